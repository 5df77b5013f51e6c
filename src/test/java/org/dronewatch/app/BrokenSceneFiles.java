package org.dronewatch.app;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** Scene files with one mistake each, made from a good one: wrong names and values, and what is wrong as a document. */
final class BrokenSceneFiles {
    /** A scene that is right as it is. */
    static final String GOOD =
            """
            world:
              models:
                - {file: site.obj, upAxis: z, scale: 0.5, position: [1 km, 0, 5], heading: 90 deg}
              backgroundNoise: 41.5 dB
              noiseShape: [0, -3, -6, -9, -12, -15, -18, -21]
              atmosphere: {temperature: 15 degC, humidity: 40 %, pressure: 950 hPa}
              surfaces:
                materials: {ground: grass_turf}
                defaultSurface: solid
              rain: 4 mm/h
              origin: {latitude: 50.0755 deg, longitude: 14.4378 deg}
            drones:
              one:
                model: {file: packaged:quadrotor.obj}
                flight: {kind: inbound, target: [0, 0, 10], bearing: 45 deg, height: 20 m, distance: 300 m, standoff: 5 m}
                speed: 18 km/h
                acceleration: 2 m/s2
                radar: {crossSection: 0.02 m2, fluctuation: swerling-1}
                soundLevel: 52 dB
                soundPowerLevel: 85 dB
                sound: hexacopter
                directivity: rotor
                heat: {excess: 6 K, coolingTime: 90 s}
                swarm: {count: 4, spacing: 5 m, formation: wedge}
                label: {role: attack, purpose: strike, platform: fpv}
              low:
                model: {file: packaged:quadrotor.obj}
                flight: {kind: dive, target: [0, 0, 5], bearing: 10 deg, distance: 300 m, height: 80 m, angle: 40 deg}
            sensors:
              eye:
                kind: camera
                position: [0, 0, 10]
                aim: {azimuth: 180 deg, elevation: -5 deg}
                width: 1280
                height: 720
                fov: 40 deg
                fovAxis: horizontal
                rate: 25 Hz
                detection: {pixels: 20}
              ear:
                kind: acoustic
                position: [0, 0, 11]
                radius: 0.4 m
                threshold: 9 dB
                arrayGain: 3 dB
                propagation: {kind: energy-model, rays: 100, accuracy: 0.5 dB, roulette: 0.25, diffraction: iso9613, criterion: best-band}
              echo:
                use: blighter-a400
                position: [0, 0, 12]
                minRange: 60 m
                polarisation: vertical
                accuracy: {range: 4 m, azimuth: 0.5 deg, elevation: 2 deg}
              warm:
                kind: thermal
                position: [0, 0, 13]
                netd: 40 mK
                transmission: 80 %
                task: recognition
                positioner:
                  use: viper
                  cues: [echo, eye]
                  search: {kind: sweep, width: 90 deg, height: 10 deg, rows: 2, speed: 20 deg/s}
                  zoom: {cued: 6 deg, tracked: 2 deg, time: 1.5 s}
            alert:
              rule: {kind: several-sensors, count: 2, within: 4 s}
              confirm: {hits: 2, looks: 3}
              protect: {centre: [0, 0, 5], radius: 30 m}
              response: 20 s
            prices:
              currency: EUR
              sensors: {warm: 80000, echo: 300000}
            run:
              duration: 1 min
              seed: 7
            sweep:
              parameter: world.backgroundNoise
              from: 20 dB
              to: 40 dB
              count: 3
            """;

    private static final long SEED = 20_261_121;

    private final NamedFiles files = new NamedFiles();
    private final SplittableRandom random = new SplittableRandom(SEED);

    private BrokenSceneFiles() {}

    /** All files by a name that says what is wrong. */
    static Map<String, byte[]> all() {
        BrokenSceneFiles corpus = new BrokenSceneFiles();
        corpus.typos();
        corpus.values();
        corpus.missing();
        corpus.doubled();
        corpus.paths();
        BrokenDocuments.all().forEach(corpus.files::add);
        return corpus.files.all();
    }

    /** The good scene with a piece of it replaced. */
    private void change(String what, String from, String to) {
        if (!GOOD.contains(from)) {
            throw new IllegalStateException("no '" + from + "' in the good scene");
        }
        files.add(what + " " + from + " -> " + to, GOOD.replaceFirst(java.util.regex.Pattern.quote(from), to));
    }

    private void typos() {
        List<String> fields = List.of(
                "world",
                "models",
                "file",
                "upAxis",
                "scale",
                "heading",
                "backgroundNoise",
                "noiseShape",
                "atmosphere",
                "temperature",
                "humidity",
                "pressure",
                "surfaces",
                "defaultSurface",
                "rain",
                "drones",
                "model",
                "flight",
                "target",
                "bearing",
                "distance",
                "standoff",
                "speed",
                "acceleration",
                "radar",
                "crossSection",
                "fluctuation",
                "soundLevel",
                "soundPowerLevel",
                "directivity",
                "sensors",
                "aim",
                "azimuth",
                "elevation",
                "width",
                "fovAxis",
                "rate",
                "detection",
                "pixels",
                "radius",
                "threshold",
                "arrayGain",
                "propagation",
                "rays",
                "accuracy",
                "roulette",
                "diffraction",
                "criterion",
                "minRange",
                "polarisation",
                "run",
                "duration",
                "seed",
                "sweep",
                "parameter",
                "count",
                "heat",
                "excess",
                "coolingTime",
                "swarm",
                "formation",
                "label",
                "purpose",
                "platform",
                "angle",
                "netd",
                "transmission",
                "task",
                "positioner",
                "use",
                "cues",
                "search",
                "rows",
                "zoom",
                "cued",
                "alert",
                "rule",
                "within",
                "confirm",
                "hits",
                "protect",
                "response",
                "prices",
                "currency");
        for (String field : fields) {
            int at = 1 + random.nextInt(field.length() - 1);
            String wrong = random.nextBoolean()
                    ? field.substring(0, at) + field.substring(at + 1) + "q"
                    : field.substring(0, at) + field.charAt(at) + field.substring(at);
            files.add("typo " + field + " -> " + wrong, GOOD.replaceFirst("\\b" + field + ":", wrong + ":"));
        }
        for (String name : List.of(
                "inbound",
                "swerling-1",
                "hexacopter",
                "rotor",
                "camera",
                "horizontal",
                "acoustic",
                "energy-model",
                "iso9613",
                "best-band",
                "blighter-a400",
                "vertical",
                "grass_turf",
                "wedge",
                "strike",
                "fpv",
                "dive",
                "thermal",
                "recognition",
                "viper",
                "sweep",
                "several-sensors",
                "solid")) {
            change("typo", ": " + name, ": " + name.substring(0, name.length() - 1) + "x");
        }
    }

    private void values() {
        for (String wrong : List.of(
                "18 kg",
                "18 km",
                "five",
                "-1",
                "1e99",
                "1e999",
                "NaN",
                "Infinity",
                "0x10",
                "18 km/h/h",
                "[18]",
                "{a: 18}",
                "\"\"",
                "~",
                "18 18")) {
            change("speed", "speed: 18 km/h", "speed: " + wrong);
        }
        for (String wrong : List.of("0", "-3", "1.5", "99999999999999999999", "1280 m", "true")) {
            change("width", "width: 1280", "width: " + wrong);
        }
        for (String wrong : List.of("200 deg", "0", "-40 deg", "40 m", "40 degrees of freedom")) {
            change("fov", "fov: 40 deg", "fov: " + wrong);
        }
        for (String wrong : List.of("170 %", "-1 %", "40 %%", "1.01")) {
            change("humidity", "humidity: 40 %", "humidity: " + wrong);
        }
        for (String wrong : List.of("[radio]", "[ear]", "[warm]", "echo", "[echo, 5]", "{a: 1}")) {
            change("cues", "cues: [echo, eye]", "cues: " + wrong);
        }
        change("zoom", "cued: 6 deg", "cued: 60 deg");
        change("zoom", "tracked: 2 deg", "tracked: 0");
        change("search", "rows: 2", "rows: 0");
        change("search", "speed: 20 deg/s", "speed: 20 deg");
        change("rule", "count: 2", "count: 5");
        change("rule", "within: 4 s", "within: -4 s");
        change("confirm", "hits: 2", "hits: 4");
        change("protect", "centre: [0, 0, 5]", "centre: 5");
        change("protect", "radius: 30 m", "radius: -30 m");
        change("response", "response: 20 s", "response: soon");
        change("prices", "warm: 80000", "warn: 80000");
        change("prices", "warm: 80000", "warm: -1");
        change("prices", "currency: EUR", "currency: \"<b>\"");
        change("swarm", "{count: 4, spacing", "{count: 0, spacing");
        change("swarm", "{count: 4, spacing", "{count: 2000, spacing");
        change("swarm", "spacing: 5 m", "spacing: 0");
        change("heat", "excess: 6 K", "excess: 6 degC per hour");
        change("heat", "coolingTime: 90 s", "coolingTime: 0");
        change("dive", "angle: 40 deg", "angle: 5 deg");
        change("netd", "netd: 40 mK", "netd: 0");
        change("accuracy", "range: 4 m", "range: -4 m");
        change("temperature", "temperature: 15 degC", "temperature: 15");
        change("temperature", "temperature: 15 degC", "temperature: -300 degC");
        change("pressure", "pressure: 950 hPa", "pressure: 950");
        change("noise", "backgroundNoise: 41.5 dB", "backgroundNoise: 500 dB");
        change("noise", "-18, -21]", "-18]");
        change("noise", "-18, -21]", "-18, -21, -24]");
        change("rain", "rain: 4 mm/h", "rain: -4");
        change("rays", "rays: 100", "rays: 0");
        change("roulette", "roulette: 0.25", "roulette: 1");
        change("elevation", "elevation: -5 deg", "elevation: -95 deg");
        change("position", "position: [0, 0, 12]", "position: [0, 0]");
        change("position", "position: [0, 0, 12]", "position: [0, 0, up]");
        change("position", "position: [0, 0, 12]", "position: {x: 1, y: 2}");
        change("range", "minRange: 60 m", "minRange: 60 km");
        change("standoff", "standoff: 5 m", "standoff: 400 m");
        change("duration", "duration: 1 min", "duration: 1e9");
        change("seed", "seed: 7", "seed: 7.5");
        change("seed", "seed: 7", "seed: 123456789012345678901234567890");
        change("count", "count: 3", "count: 1");
        change("count", "count: 3", "count: 1000000");
        change("sweep", "from: 20 dB", "from: 20 kg");
        change("sweep", "to: 40 dB", "to: 400 dB");
        change("sweep", "world.backgroundNoise", "world.nothing");
        change("id", "  one:", "  o ne:");
        change("scale", "scale: 0.5", "scale: 0");
        change("origin", "latitude: 50.0755 deg", "latitude: 95 deg");
        change("origin", "longitude: 14.4378 deg", "lon: 14");
        change("cross-section", "crossSection: 0.02 m2", "crossSection: 0");
    }

    private void missing() {
        files.add("missing kind", GOOD.replaceFirst("(?s)  eye:.*  ear:", "  eye: {position: [0, 0, 1]}\n  ear:"));
        change("missing", "    position: [0, 0, 10]\n", "");
        change("missing", "    model: \\{file: packaged:quadrotor.obj}\n".replace("\\", ""), "");
        change("missing", "file: site.obj, ", "");
        change("missing", "  parameter: world.backgroundNoise\n", "");
        change("missing", "distance: 300 m, ", "");
        change("missing", "target: [0, 0, 10], ", "");
        change("missing", "    use: blighter-a400\n", "");
        files.add("missing world", GOOD.substring(GOOD.indexOf("drones:")));
        change("empty", "duration: 1 min", "duration:");
        change("empty", "use: blighter-a400", "use:");
        change("empty", "kind: acoustic", "kind:");
    }

    private void doubled() {
        for (String field : List.of(
                "speed: 18 km/h",
                "width: 1280",
                "fov: 40 deg",
                "rate: 25 Hz",
                "radius: 0.4 m",
                "seed: 7",
                "count: 3",
                "rain: 4 mm/h")) {
            String line = GOOD.lines()
                    .filter(one -> one.strip().equals(field))
                    .findFirst()
                    .orElseThrow();
            change("doubled", line + "\n", line + "\n" + line + "\n");
        }
        files.add("doubled world", GOOD + "world: {models: [a.obj]}\n");
        files.add("doubled run", GOOD + "run: {duration: 5}\n");
        change("doubled", "  ear:\n", "  eye:\n");
    }

    private void paths() {
        for (String path : List.of(
                "../site.obj",
                "../../etc/passwd",
                "/etc/passwd",
                "a/../../site.obj",
                "nowhere.obj",
                ".",
                "..",
                "packaged:nothing.obj",
                "packaged:../hill.obj",
                "packaged:",
                "http://example.org/a.obj",
                "site.obj/x",
                "~/site.obj")) {
            change("path", "file: site.obj", "file: \"" + path + "\"");
        }
        change("path", "use: blighter-a400", "use: ../blighter-a400");
        change("path", "use: blighter-a400", "use: /etc/passwd");
        change("path", "use: blighter-a400", "use: site");
    }
}
