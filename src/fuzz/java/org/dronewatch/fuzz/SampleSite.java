package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;
import tools.jackson.dataformat.yaml.YAMLMapper;

/** A small site with a drone, and scenes on it that are quick to run. */
final class SampleSite {
    /** The scene file of a case. */
    static final String SCENE = "scene.yaml";

    /** A slope with a box on it, z up. */
    static final String SITE =
            """
            mtllib site.mtl
            v -300 -300 0
            v 300 -300 0
            v 300 300 12
            v -300 300 12
            v -2 -2 0
            v 2 -2 0
            v 2 2 0
            v -2 2 0
            v -2 -2 10
            v 2 -2 10
            v 2 2 10
            v -2 2 10
            usemtl grass
            f 1 2 3 4
            usemtl brick
            f 5 6 10 9
            f 6 7 11 10
            f 7 8 12 11
            f 8 5 9 12
            f 9 10 11 12
            """;

    /** A small octahedron. */
    static final String DRONE =
            """
            v 0.4 0 0
            v -0.4 0 0
            v 0 0.4 0
            v 0 -0.4 0
            v 0 0 0.2
            v 0 0 -0.2
            f 1 3 5
            f 3 2 5
            f 2 4 5
            f 4 1 5
            f 3 1 6
            f 2 3 6
            f 4 2 6
            f 1 4 6
            """;

    private static final String COLOURS = "newmtl grass\nKd 0.1 0.5 0.1\nnewmtl brick\nKd 0.6 0.2 0.1\n";

    /** A scene with every kind of sensor and flight, each cheap. */
    static final String RICH =
            """
            world:
              models:
                - {file: site.obj, upAxis: z, scale: 1, position: [0, 0, 0], heading: 0 deg}
              backgroundNoise: 30 dB
              noiseShape: {hz63: 0, hz125: -3, hz250: -6, hz500: -9, hz1000: -12, hz2000: -15, hz4000: -18, hz8000: -21}
              atmosphere: {temperature: 15 degC, humidity: 40 %, pressure: 950 hPa}
              surfaces:
                materials: {grass: grass_turf, brick: brick_rough}
                defaultSurface: solid
              rain: 4 mm/h
              light: {visibility: 10 km, contrastAtVisibility: 0.05, illuminance: 5000, sun: {azimuth: 100 deg, elevation: 20 deg}}
              origin: {latitude: 50.0755 deg, longitude: 14.4378 deg, height: 200 m}
            drones:
              one:
                model: {file: drone.obj, upAxis: z, scale: 1}
                flight: {kind: inbound, target: [0, 0, 10], bearing: 45 deg, height: 20 m, distance: 60 m, standoff: 5 m}
                speed: 18 km/h
                acceleration: 2 m/s2
                radar: {crossSection: 0.02 m2, fluctuation: swerling-1}
                soundLevel: 52 dB
                soundPowerLevel: 85 dB
                glideReduction: 20 dB
                sound: hexacopter
                directivity: rotor
                tones: {rotorSpeed: 6150 rpm, blades: 2, shares: [0.5, 0.3, 0.3]}
                heat: {excess: 6 K, coolingTime: 90 s}
                radio: {control: radio, frequency: 2.4 GHz, power: 20, pilot: [100, 50, 5], pilotPower: 20}
                swarm: {count: 2, spacing: 5 m, formation: wedge}
                label: {role: attack, purpose: strike, platform: fpv}
              two:
                model: drone.obj
                flight: {kind: dive, target: [0, 0, 5], bearing: 10 deg, distance: 80 m, height: 40 m, angle: 50 deg}
                radar: {crossSection: 0.01, aspects: [0.01, 0.02, 0.03]}
              three:
                model: drone.obj
                flight: {kind: waypoints, points: [[50, 50, 30], [20, 10, 25], [0, 30, 20]]}
                speed: 10 m/s
              four:
                model: drone.obj
                flight: {kind: hover, position: [20, 30, 15], heading: 30 deg}
            sensors:
              eye:
                kind: camera
                position: [0, 0, 12]
                aim: {azimuth: 45 deg, elevation: 5 deg}
                width: 64
                height: 48
                fov: 40 deg
                fovAxis: horizontal
                rate: 10 Hz
                detection: {kind: pixel-threshold, pixels: 2}
              task:
                kind: camera
                position: [1, 0, 12]
                aim: {lookAt: [20, 30, 15]}
                width: 64
                height: 48
                fov: 0.5
                rate: 5 Hz
                detection: {kind: target-task, task: detection, probability: 0.5, contrast: 0.5, contrastThreshold: 0.02, shotNoiseIlluminance: 100, exposure: 0.01, sunExclusionAngle: 5 deg}
              ear:
                kind: acoustic
                position: [0, 3, 11]
                radius: 0.4 m
                rate: 2 Hz
                threshold: 9 dB
                arrayGain: 3 dB
                propagation: {kind: energy-model, rays: 100, accuracy: 0.5 dB, roulette: 0.25, maxOrder: 10, imageSourceOrder: 2, diffraction: iso9613, criterion: best-band}
              level:
                kind: acoustic
                position: [0, -3, 11]
                rate: 2 Hz
                propagation: {kind: level-model, initialRays: 5, reflectionsPerHit: 4, attenuation: 0.05, maxOrder: 2, rayBudget: 2000}
              echo:
                kind: radar
                position: [0, 0, 14]
                aim: {azimuth: 40 deg, elevation: 10 deg}
                azimuthWidth: 120 deg
                elevationWidth: 60 deg
                minRange: 5 m
                maxRange: 5 km
                minSpeed: 0.1
                maxSpeed: 100
                rate: 4 Hz
                frequency: 10 GHz
                polarisation: vertical
                budget: {kind: hardware, power: 1, gain: 30, integrationTime: 0.01, sweepBandwidth: 10 MHz, noiseFigure: 3, losses: 2}
                detection: {kind: chance, falseAlarm: 1e-6, pulses: 10}
                accuracy: {range: 4 m, azimuth: 0.5 deg, elevation: 2 deg}
                beam: {azimuthBeamwidth: 2 deg, elevationBeamwidth: 8 deg, sideLobes: 25 dB, steering: both, scanLoss: 1.5}
                clutter: {ground: {kind: land-cover, cover: woods}, improvement: 40 dB, rainImprovement: 10 dB}
                notch: {kind: high-pass, halfPowerSpeed: 1 m/s, order: 2}
              sheet:
                kind: radar
                position: [0, 1, 14]
                budget: {kind: data-sheet, range: 1000, crossSection: 0.01, probability: 0.9, falseAlarm: 1e-6, fluctuation: steady}
              radio: {kind: rf, position: [4, 0, 13], rate: 2 Hz, minFrequency: 400 MHz, maxFrequency: 6 GHz, gain: 3, bandwidth: 10 MHz, noiseFigure: 6, clutter: 2, threshold: 6}
              warm:
                kind: thermal
                position: [0, 0, 13]
                aim: {azimuth: 45 deg, elevation: 5 deg}
                width: 64
                height: 48
                fov: 30 deg
                rate: 5 Hz
                netd: 40 mK
                transmission: 80 %
                minSnr: 2
                task: recognition
                probability: 0.5
                positioner:
                  cues: [echo, eye]
                  panSpeed: 30 deg/s
                  tiltSpeed: 30 deg/s
                  minTilt: -20 deg
                  maxTilt: 60 deg
                  delay: 0.2 s
                  hold: 2 s
                  lockPixels: 6
                  search: {kind: sweep, width: 90 deg, height: 10 deg, rows: 2, speed: 20 deg/s}
                  zoom: {cued: 6 deg, tracked: 2 deg, time: 1.5 s}
            alert:
              rule: {kind: several-sensors, count: 2, within: 4 s}
              confirm: {hits: 2, looks: 3}
              protect: {centre: [0, 0, 5], radius: 3 m}
              response: 2 s
            prices:
              currency: EUR
              sensors: {warm: 80000, echo: 300000}
            run:
              duration: 0.5 s
              seed: 7
            """;

    private SampleSite() {}

    /** A case of a scene on the site. */
    static FuzzCase scene(String what, String scene, String... arguments) {
        return FuzzCase.of(what, SCENE, scene, arguments)
                .with("site.obj", SITE)
                .with("site.mtl", COLOURS)
                .with("drone.obj", DRONE);
    }

    /** A part of the rich scene that is quick to run: one or two drones and sensors of it. */
    static String part(Dice dice) {
        ObjectNode scene = (ObjectNode) YAMLMapper.shared().readTree(RICH);
        keep((ObjectNode) scene.get("drones"), dice);
        keep((ObjectNode) scene.get("sensors"), dice);
        if (dice.oneIn(2)) {
            lookAtADrone(scene);
        }
        scene.remove("prices");
        if (scene.at("/sensors/warm/positioner").isObject()) {
            ((ObjectNode) scene.at("/sensors/warm/positioner")).remove("cues");
        }
        if (!dice.oneIn(3)) {
            ((ObjectNode) scene.get("world")).remove("origin");
        }
        return YAMLMapper.shared().writeValueAsString(scene);
    }

    /** Puts a drone into the middle of what the sensors see: however narrow the view is, it then contains something. */
    private static void lookAtADrone(ObjectNode scene) {
        ArrayNode place = JsonMapper.shared().createArrayNode().add(20).add(30).add(15);
        ObjectNode flight = ((ObjectNode) scene.get("drones")).putObject("seen").put("model", "drone.obj");
        flight.putObject("flight").put("kind", "hover").set("position", place);
        scene.get("sensors").forEach(sensor -> {
            if (sensor.has("aim")) {
                ((ObjectNode) sensor).putObject("aim").set("lookAt", place);
            }
        });
    }

    private static void keep(ObjectNode parts, Dice dice) {
        List<String> names = new ArrayList<>(parts.propertyNames());
        for (int i = dice.oneIn(4) ? 2 : 1; i > 0; i--) {
            names.remove(dice.pick(names));
        }
        parts.remove(names);
    }

    /** The packaged scenes, on this site instead of theirs. */
    static List<String> packagedScenes() {
        return List.of(
                        "acoustic-range",
                        "camera-range",
                        "closed-space",
                        "cued-camera",
                        "glider",
                        "hill-radar",
                        "multi-sensor")
                .stream()
                .map(SampleSite::packaged)
                .toList();
    }

    /** The sensor file that one of the packaged scenes needs in its directory. */
    static String roofCamera() {
        return read("roof-camera");
    }

    private static String packaged(String name) {
        return read(name)
                .replaceAll("packaged:(hill|house|cathedral)\\.obj", "site.obj")
                .replace("packaged:quadrotor.obj", "drone.obj");
    }

    private static String read(String name) {
        try {
            return Files.readString(Path.of("scenes", name + ".yaml"));
        } catch (IOException e) {
            throw new IllegalStateException("a packaged scene cannot be read", e);
        }
    }
}
