package org.dronewatch.report.html;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronewatch.geometry.Position;
import org.dronewatch.picture.Yard;
import org.dronewatch.scene.Pointings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

class HtmlReportTest {
    @TempDir
    private Path directory;

    private static String report(Scene scene, List<Figure> figures) throws IOException {
        SceneRunner runner = new SceneRunner(scene);
        Looks looks = new Looks();
        SceneResult result = runner.listener(looks).run();
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new HtmlReport(result, looks, runner.stage(runner.settingsOfRuns().get(0)), figures, List.of()).write(page);
        return page.toString(StandardCharsets.UTF_8);
    }

    private static Document parsed(String page) throws IOException {
        try {
            return DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .parse(new ByteArrayInputStream(page.getBytes(StandardCharsets.UTF_8)));
        } catch (SAXException | javax.xml.parsers.ParserConfigurationException e) {
            throw new AssertionError(e);
        }
    }

    private static List<String> texts(Document page, String tag) {
        NodeList nodes = page.getElementsByTagName(tag);
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < nodes.getLength(); i++) {
            texts.add(nodes.item(i).getTextContent().strip());
        }
        return texts;
    }

    @Test
    void saysWhoFoundTheGliderAndWhyTheOthersDidNot() throws IOException {
        String page = report(
                new SceneFile(Path.of("scenes", "glider.yaml")),
                List.of(new Figure("a <picture>", new byte[] {1, 2, 3})));
        Document document = parsed(page);

        assertThat(texts(document, "p"))
                .anyMatch(text -> text.equals("'glider' is first detected by 'radar' (radar), 664 m away, 8 s after the"
                        + " start; 6 of 7 sensors never detect it. The alert comes after 8 s, by 'radar', 609 m and 40.6 s"
                        + " of flight before what is protected; 30 s are needed: in time."));
        assertThat(texts(document, "td"))
                .anyMatch(text -> text.startsWith("always silent by radio (autonomous)"))
                .anyMatch(text ->
                        text.matches("81 % of the time out of its field of view; 19 % of the time too small or too"
                                + " faint: at best 8 px \\(needs 12\\), 159 m away"))
                .anyMatch(text ->
                        text.matches("always too quiet: at best [0-9.]+ dB \\(needs 47\\), \\d+ m away; its motors"
                                + " are off 79 % of the time"));
        // The radar loses it at 38 s, when it flies above the radar's field.
        assertThat(texts(document, "td"))
                .containsSubsequence("radar", "38.0", "327.8", "always out of its field of view");
        assertThat(texts(document, "th")).contains("from then on");
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
                .anyMatch(text -> text.startsWith("What a camera makes out rests on an assumed contrast"))
                .anyMatch(text -> text.startsWith("A mount here needs no time to speed up"))
                .noneMatch(text -> text.startsWith("A camera that counts pixels"));
        assertThat(texts(document, "td"))
                .contains("26\u202f000", "35\u202f000", "not known", "without 1 of unknown price")
                .contains("Blighter A400 air security radar, antenna M10S", "fixed, cued")
                .anyMatch(text -> text.startsWith("Piranha 46 HR data sheet: "))
                .anyMatch(text ->
                        text.contains("always too small or too faint: at best") && text.contains("(needs 50 %)"));
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

        assertThat(texts(document, "td").stream().filter(text -> text.contains("too slow for it")))
                .hasSize(2)
                .allMatch(text -> text.startsWith("always too slow for it (less than 1.0 m/s nearer or farther)"));
        assertThat(texts(document, "td"))
                .anyMatch(text -> text.startsWith("always too fast for it (more than 60 m/s)"));
    }

    @Test
    void tellsOfEachDroneOfASwarmWithItsLabel() throws IOException {
        Path file = directory.resolve("swarm.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  x:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 50, 150]}
                    swarm: 25
                    label: {role: decoy, platform: fixed-wing}
                sensors:
                  radar: {use: droneshield-radarone, position: [0, 0, 140], aim: {azimuth: 0, elevation: 0}}
                run: {duration: 1}
                """);
        Document document = parsed(report(new SceneFile(file), List.of()));

        assertThat(texts(document, "td").stream().filter("decoy, fixed-wing"::equals))
                .hasSize(25);
        assertThat(texts(document, "td")).contains("x-1", "x-25");
        assertThat(texts(document, "p")).contains("Of 25 drones (0 of them attack) there is an alert to none.");
        Files.writeString(file, Files.readString(file).replace("role: decoy", "role: attack"));
        assertThat(texts(parsed(report(new SceneFile(file), List.of())), "p"))
                .contains("Of 25 drones there is an alert to none. 'x-1' is not detected by any sensor. 'x-2' is not"
                        + " detected by any sensor. 'x-3' is not detected by any sensor. 'x-4' is not detected by any"
                        + " sensor. The table tells of 21 more like these.");
    }

    @Test
    void tablesOfASiteWithManySensorsAndDronesStayShort() throws IOException {
        Path file = directory.resolve("many.yaml");
        StringBuilder scene = new StringBuilder("world: {models: [packaged:hill.obj]}\ndrones:\n  x: {model: "
                + "packaged:quadrotor.obj, flight: {kind: hover, position: [0, 50, 150]}, swarm: 10}\nsensors:\n");
        for (int i = 0; i < 13; i++) {
            scene.append("  s")
                    .append(i)
                    .append(": {use: droneshield-rfone, position: [")
                    .append(i)
                    .append(", 0, 147]}\n");
        }
        Files.writeString(file, scene + "run: {duration: 1}\n");
        Document all = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(all, "td").stream().filter("rf"::equals)).hasSize(130 + 13);

        Files.writeString(
                file,
                scene.toString().replace("swarm: 10", "swarm: 10, radio: {control: fibre}") + "run: {duration: 1}\n");
        Document none = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(none, "p"))
                .contains("Without the 130 pairs of sensor and drone that came to no detection.")
                .contains("And 70 pairs of sensor and drone more.");
        assertThat(texts(none, "td")).contains("always silent by radio (fibre); it came as near as 50 m");
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
        new HtmlReport(result, looks, runner.stage(runner.settings()), List.of(), List.of()).write(page);

        assertThat(texts(parsed(page.toString(StandardCharsets.UTF_8)), "p"))
                .contains("'quadrotor' is not detected by any sensor. The run was cut short.");
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
        Optional<Look> weak = Optional.of(new Look(1, 30, 7, 12, "px"));

        assertThat(reasons.of("away", "quadrotor", weak))
                .isEqualTo("always out of its field of view; it came as near as 5 m");
        assertThat(reasons.of("covered", "quadrotor", weak)).contains("hidden by yard.obj (brick)");
        assertThat(reasons.of("short", "quadrotor", weak)).isEqualTo("always out of range; it came as near as 5 m");
        assertThat(reasons.of("camera", "quadrotor", weak))
                .contains("too small or too faint: at best 7 px (needs 12), 30 m away");
        assertThat(reasons.of("microphone", "quadrotor", Optional.of(new Look(1, 30, 41.26, 45, "dB"))))
                .isEqualTo("always too quiet: at best 41.3 dB (needs 45), 30 m away");
        assertThat(reasons.of(
                        "microphone", "quadrotor", Optional.of(new Look(1, 30, Double.NEGATIVE_INFINITY, 45, "dB"))))
                .startsWith("always too quiet for any reading; it came as near as");
        assertThat(reasons.of("camera", "quadrotor", Optional.of(new Look(1, 30, 0.031, 0.5, ""))))
                .contains("at best 3.1 % (needs 50 %), 30 m away");
    }
}
