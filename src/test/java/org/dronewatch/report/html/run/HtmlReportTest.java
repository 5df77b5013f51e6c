package org.dronewatch.report.html.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.report.html.ReportPage.parsed;
import static org.dronewatch.report.html.ReportPage.report;
import static org.dronewatch.report.html.ReportPage.texts;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Yard;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

class HtmlReportTest {
    private static final List<String> QUADROTOR = List.of("quadrotor");

    @TempDir
    private Path directory;

    @Test
    void saysWhoFoundTheGliderAndWhyTheOthersDidNot() throws IOException {
        String page = report(
                new SceneFile(Path.of("scenes", "glider.yaml")),
                List.of(new Figure("a <picture>", new byte[] {1, 2, 3})));
        Document document = parsed(page);

        assertThat(texts(document, "p"))
                .anyMatch(text ->
                        text.equals("'glider' is first detected by 'radar' (radar) at a range of 664 m, 8 s after"
                                + " the start; 5 of 7 sensors never detect it. The alert is raised by 'radar' 8 s after the start,"
                                + " when the drone is 609 m (40.6 s of flight) from the protected zone: in time (the response"
                                + " takes 30 s)."));
        assertThat(texts(document, "td"))
                .anyMatch(text -> text.startsWith("always radio-silent (autonomous)"))
                .anyMatch(text ->
                        text.matches("56 % of the time: out of its field of view; 44 % of the time: too small or too"
                                + " faint \\(best 8 px at 389 m, threshold 12 px\\)"))
                .anyMatch(
                        text -> text.matches("always too quiet \\(best [0-9.]+ dB at \\d+ m, threshold 47 dB\\); motors"
                                + " off 79 % of the time"));
        // The radar loses it at 38 s, when it flies above the radar's field.
        assertThat(texts(document, "td"))
                .containsSubsequence("radar", "38.0", "327.8", "out of its field of view from then on");
        assertThat(texts(document, "th")).contains("reason after loss");
        assertThat(texts(document, "figcaption")).containsExactly("a <picture>");
        assertThat(page).contains("data:image/png;base64,AQID");
        // Nothing is asked for from anywhere.
        assertThat(page.replace("http://www.w3.org/", "")).doesNotContain("http:", "https:", "<script", "<link");
        assertThat(texts(document, "td")).noneMatch(text -> text.contains("NaN") || text.contains("Infinity"));
    }

    @Test
    void tellsWhatSensorsCostAndWhereTheirSettingsComeFrom() throws IOException {
        Document document = parsed(report(new SceneFile(Path.of("scenes", "cued-camera.yaml")), List.of()));

        assertThat(texts(document, "th")).contains("cost [EUR]");
        assertThat(texts(document, "li"))
                .anyMatch(text -> text.startsWith("Detection by cameras depends on an assumed contrast"))
                .anyMatch(text -> text.startsWith("Positioners accelerate instantly"))
                .noneMatch(text -> text.startsWith("A camera that counts pixels"));
        assertThat(texts(document, "td"))
                .contains("26\u202f000", "35\u202f000", "unknown", "excluding 1 of unknown price")
                .contains("Blighter A400 air security radar, antenna M10S", "fixed, cued")
                .anyMatch(text -> text.startsWith("Piranha 46 HR data sheet: "))
                .anyMatch(text ->
                        text.contains("always too small or too faint (best") && text.contains(", threshold 50 %)"));
    }

    /** What is left out depends on the settings of each radar, and birds are false alarms. */
    @Test
    void theLimitationsAreThoseOfTheScene() throws IOException {
        String noBirds = "False alarms are not modelled: no sensor's false-alarm rate is known.";
        String noClutter =
                "For radars without 'clutter', no echoes of the ground or of rain compete with those of drones.";
        assertThat(limitations("birds"))
                .contains("Birds that sensors detect are the only false alarms: no sensor's false-alarm rate"
                        + " is known.")
                .contains(noClutter)
                .doesNotContain(noBirds);
        assertThat(limitations("meadow")).contains(noBirds).doesNotContain(noClutter);
        assertThat(limitations("false-alarms"))
                .anyMatch(text -> text.startsWith("Sensors whose rate of false alarms is stated"))
                .noneMatch(text -> text.contains("too."));
    }

    private static List<String> limitations(String scene) throws IOException {
        SceneRunner runner =
                new SceneRunner(new SceneFile(Path.of("scenes", scene + ".yaml"))).set("run.duration", "2 s");
        Looks looks = new Looks();
        SceneResult result = runner.listener(looks).run();
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new HtmlReport(result, looks, run -> new RunView(runner.stage(run.settings()), List.of()), List.of(), Map.of())
                .write(page);
        return texts(parsed(page.toString(StandardCharsets.UTF_8)), "li");
    }

    @Test
    void aRadarThatIsTooSlowIsToldFromOneThatIsTooWeak() throws IOException {
        Path file = directory.resolve("slow.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  lurker: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 150, 180]}}
                  circler: {model: packaged:quadrotor.obj, flight: {kind: orbit, centre: [0, 0, 180], radius: 150}}
                  dart:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 600, 200], to: [0, 100, 190]}
                    speed: 90 m/s
                sensors:
                  radar:
                    kind: radar
                    position: [0, 0, 145]
                    elevationWidth: 90 deg
                    budget: {kind: data-sheet, range: 1000, crossSection: 0.01}
                    maxSpeed: 60 m/s
                run: {duration: 5}
                """);
        Document document = parsed(report(new SceneFile(file), List.of()));

        assertThat(texts(document, "td").stream().filter(text -> text.contains("too slow for the sensor")))
                .hasSize(2)
                .allMatch(text -> text.startsWith("always too slow for the sensor (radial speed below 1.0 m/s)"));
        assertThat(texts(document, "td"))
                .anyMatch(text -> text.startsWith("always too fast for the sensor (radial speed above 60 m/s)"));
    }

    /** The speed that passes a notch depends on the strength of the echo: one reason gives least and greatest speed. */
    @Test
    void aRadarWithANotchGivesOneReasonForAllSpeedsThatAreTooSlow() throws IOException {
        Path file = directory.resolve("notch.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  circler: {model: packaged:quadrotor.obj, flight: {kind: orbit, centre: [60, 0, 180], radius: 150}}
                sensors:
                  radar:
                    kind: radar
                    position: [0, 0, 145]
                    elevationWidth: 90 deg
                    budget: {kind: data-sheet, range: 1000, crossSection: 0.01}
                    notch: {kind: high-pass, halfPowerSpeed: 20 m/s}
                run: {duration: 10}
                """);
        List<String> slow = texts(parsed(report(new SceneFile(file), List.of())), "td").stream()
                .filter(text -> text.contains("too slow for the sensor"))
                .toList();

        assertThat(slow)
                .singleElement()
                .asString()
                .matches(".*too slow for the sensor \\(radial speed below ([0-9.]+)" + " to (?!\\1 )[0-9.]+ m/s\\).*");
        assertThat(slow.get(0).split("too slow", -1)).hasSize(2);
    }

    /** Sound that is heard long before the drone comes into view is not late by 0 s. */
    @Test
    void anAlertFromSoundHasNoDelayFromView() throws IOException {
        Path file = directory.resolve("sound.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj], origin: {latitude: -33.9 deg, longitude: -18.4 deg, height: 212.5 m}}
                drones:
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 40, 150], to: [0, -200, 150]}
                    speed: 10 m/s
                sensors:
                  microphone: {kind: acoustic, position: [0, 0, 145]}
                  camera: {kind: camera, position: [0, 0, 145], aim: {azimuth: 180 deg, elevation: 0 deg}}
                run: {duration: 10}
                """);
        Document document = parsed(report(new SceneFile(file), List.of()));

        assertThat(texts(document, "th"))
                .contains("first in any sensor's view [s]", "delay from first view to alert [s]");
        List<String> cells = texts(document, "td");
        int row = cells.indexOf("quadrotor");
        assertThat(Double.parseDouble(cells.get(row + 1))).isGreaterThan(4.0);
        assertThat(cells.subList(row + 2, row + 5)).containsExactly("0.0", "-", "microphone");
        assertThat(cells).contains("33.90000\u00b0 S, 18.40000\u00b0 W, 212.5 m above sea level");
    }

    @Test
    void warnsOfWeatherThatHasNoEffectAndEndsWithItsProvenance() throws IOException {
        SceneRunner runner = new SceneRunner(new Yard(directory)).set("world.light.illuminance", "0.01");
        Looks looks = new Looks();
        SceneResult result = runner.listener(looks).run();
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new HtmlReport(
                        result,
                        looks,
                        run -> new RunView(runner.stage(run.settings()), List.of()),
                        List.of(),
                        Map.of("program", "dronewatch <1>"))
                .write(page);
        Document document = parsed(page.toString(StandardCharsets.UTF_8));

        assertThat(texts(document, "p"))
                .anyMatch(text -> text.startsWith(
                        "Warning: world.light.illuminance 0.01 lx does not change what is detected by camera"));
        assertThat(texts(document, "h2")).endsWith("Limitations of the model", "Provenance");
        assertThat(texts(document, "td")).endsWith("program", "dronewatch <1>");
    }

    @Test
    void theSameResultsGiveTheSameBytes() throws IOException {
        assertThat(report(new Yard(directory), List.of())).isEqualTo(report(new Yard(directory), List.of()));
    }

    @Test
    void settingsHaveUnits() throws IOException {
        Document document = parsed(report(new SceneFile(Path.of("scenes", "glider.yaml")), List.of()));
        List<String> radar = texts(document, "td").stream()
                .filter(text -> text.contains("azimuth width"))
                .toList();
        assertThat(radar).hasSize(1);
        assertThat(radar.get(0))
                .contains("azimuth width 90\u00b0", "max range 2000 m", "frequency 10.3 GHz", "min speed 1 m/s")
                .contains("aim direction (azimuth 0\u00b0, elevation 14\u00b0)");
        Matcher bare = Pattern.compile("(range|speed|width|frequency|threshold|gain) -?[0-9.]+(,|\\)|$)")
                .matcher(radar.get(0));
        assertThat(bare.find())
                .as("a number without a unit in %s", radar.get(0))
                .isFalse();
    }

    @Test
    void aRunThatWasCutShortAndADroneThatNobodySawAreSaidSo() throws IOException {
        SceneRunner runner = new SceneRunner(new Yard(directory))
                .set("sensors.camera.detection.pixels", "100000")
                .set("world.backgroundNoise", "100")
                .cancelWhen(new java.util.function.BooleanSupplier() {
                    private int asked;

                    @Override
                    public boolean getAsBoolean() {
                        return asked++ > 10;
                    }
                });
        Looks looks = new Looks();
        SceneResult result = runner.listener(looks).run();
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new HtmlReport(result, looks, run -> new RunView(runner.stage(run.settings()), List.of()), List.of(), Map.of())
                .write(page);

        assertThat(texts(parsed(page.toString(StandardCharsets.UTF_8)), "p"))
                .contains("'quadrotor' is not detected by any sensor. The run was stopped early.");
    }

    @Test
    void reasonsTellViewRangeAndCoverApart() {
        Yard yard = new Yard(directory);
        SceneSettings settings = yard.settings();
        Position place = Yard.SENSORS;
        CameraSettings camera = (CameraSettings) settings.sensors().get("camera");
        RadarSettings radar =
                RadarSettings.at(place, LinkBudget.DataSheet.of(100, 0.01)).withFieldOfView(2 * Math.PI, Math.PI);
        SceneSettings more = settings.withSensor("away", camera.withAim(new Aim.Direction(Math.PI, 0)))
                // Close behind the wall, the drone passes above it unseen.
                .withSensor(
                        "covered", CameraSettings.at(new Position(0, -0.5, 0.5)).withLookAt(new Position(0, 25, 14)))
                .withSensor("short", radar.withRanges(0.1, 3.0));
        Reasons reasons = new Reasons(more, yard.stage(), new Pointings(), 8.0);
        Optional<BestLook> weak = Optional.of(new BestLook(1, 30, 7, 12, "px"));

        assertThat(reasons.of("away", QUADROTOR, weak))
                .isEqualTo("always out of its field of view; the closest approach was 5 m");
        assertThat(reasons.of("covered", QUADROTOR, weak)).contains("hidden by yard.obj (brick)");
        assertThat(reasons.of("short", QUADROTOR, weak)).isEqualTo("always out of range; the closest approach was 5 m");
        assertThat(reasons.of("camera", QUADROTOR, weak))
                .contains("too small or too faint (best 7 px at 30 m, threshold 12 px)");
        assertThat(reasons.of("microphone", QUADROTOR, Optional.of(new BestLook(1, 30, 41.26, 45, "dB"))))
                .as("behind the wall it would be heard if the wall were not there")
                .isEqualTo("66 % of the time: hidden by yard.obj (brick); 34 % of the time: too quiet (best 41.3 dB at"
                        + " 30 m, threshold 45 dB)");
        assertThat(reasons.of(
                        "microphone", QUADROTOR, Optional.of(new BestLook(1, 30, Double.NEGATIVE_INFINITY, 45, "dB"))))
                .contains("34 % of the time: too quiet (no measurable signal); the closest approach was");
        assertThat(reasons.of("camera", QUADROTOR, Optional.of(new BestLook(1, 30, 0.031, 0.5, ""))))
                .contains("(best 3.1 % at 30 m, threshold 50 %)");
    }
}
