package org.dronewatch.report.html.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.report.html.ReportPage.parsed;
import static org.dronewatch.report.html.ReportPage.report;
import static org.dronewatch.report.html.ReportPage.texts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;

/** Reports of swarms and of many drones. */
class SwarmReportTest {
    @TempDir
    private Path directory;

    @Test
    void aSwarmHasOneRowWithAFoldOfItsDrones() throws IOException {
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
                    label: {role: decoy, platform: fixed-wing, powerSource: fuel-cell, weight: 2.5 kg, size: 180 cm}
                sensors:
                  radar: {use: droneshield-radarone, position: [0, 0, 140], aim: {azimuth: 0, elevation: 0}}
                run: {duration: 1}
                """);
        Document document = parsed(report(new SceneFile(file), List.of()));

        assertThat(texts(document, "td").stream().filter("decoy, fixed-wing, fuel-cell, 2.5 kg, 1.8 m"::equals))
                .hasSize(1);
        assertThat(texts(document, "td").stream().filter("x (25 drones, decoy)"::equals))
                .as("alert, detections and misses")
                .hasSize(3);
        assertThat(texts(document, "summary")).contains("Individual drones of the swarms");
        assertThat(texts(document, "td")).contains("x-1", "x-25");
        assertThat(texts(document, "p")).contains("None of the 25 drones of swarm 'x' is detected.");
    }

    /** The camera looks past the leader. */
    @Test
    void theVerdictNamesTheDroneOfASwarmThatIsDetectedFirst() throws IOException {
        Path file = directory.resolve("column.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  x:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 50, 150]}
                    swarm: {count: 3, spacing: 40}
                    speed: 10 m/s
                sensors: {camera: {kind: camera, position: [0, 0, 145], aim: {azimuth: 40 deg, elevation: 5 deg}}}
                alert: {protect: {centre: [0, 0, 140], radius: 20 m}, response: 5 s}
                run: {duration: 2}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneResult result = runner.run();
        String first = result.pairs().stream()
                .filter(pair -> pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()))
                .orElseThrow()
                .drone();
        assertThat(first).isNotEqualTo("x-1");
        String verdict = new Verdict(result.runs().get(0)).inWords();

        assertThat(verdict)
                .startsWith("1 of the 3 drones of swarm 'x' is detected; the first is '" + first
                        + "', detected by 'camera'")
                .contains(
                        "An alert is raised for 1 of the swarm's 3 drones, in time for none (the response takes 5 s).");
        assertThat(texts(parsed(report(new SceneFile(file), List.of())), "p")).contains(verdict);
    }

    @ParameterizedTest
    @CsvSource({
        "1 m, 3, All 3 drones of swarm 'x' are detected; the first is",
        "1 m, 1, 'x-1' is first detected",
    })
    void theVerdictCountsTheDronesOfASwarmInPlainEnglish(String spacing, int count, String beginning)
            throws IOException {
        Path file = directory.resolve("swarm.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  x:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 50, 150]}
                    swarm: {count: %d, spacing: %s}
                sensors: {camera: {kind: camera, position: [0, 0, 150], aim: {azimuth: 0 deg, elevation: 0 deg}}}
                run: {duration: 2}
                """
                        .formatted(count, spacing));
        assertThat(new Verdict(new SceneRunner(new SceneFile(file)).run().runs().get(0)).inWords())
                .startsWith(beginning);
    }

    @Test
    void tablesOfASiteWithManySensorsAndDronesStayShort() throws IOException {
        Path file = directory.resolve("many.yaml");
        StringBuilder scene = new StringBuilder("world: {models: [packaged:hill.obj]}\ndrones:\n");
        for (int i = 0; i < 10; i++) {
            scene.append("  x")
                    .append(i)
                    .append(": {model: packaged:quadrotor.obj, flight: {kind: hover, position: [")
                    .append(i)
                    .append(", 50, 150]}RADIO}\n");
        }
        scene.append("sensors:\n");
        for (int i = 0; i < 13; i++) {
            scene.append("  s")
                    .append(i)
                    .append(": {use: droneshield-rfone, position: [")
                    .append(i)
                    .append(", 0, 147]}\n");
        }
        scene.append("run: {duration: 1}\n");
        Files.writeString(file, scene.toString().replace("RADIO", ""));
        Document all = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(all, "td").stream().filter("rf"::equals)).hasSize(60 + 13);
        assertThat(texts(all, "p"))
                .noneMatch(text -> text.contains("without a detection"))
                .contains("70 more sensor-drone pairs are not shown.");

        Files.writeString(file, scene.toString().replace("RADIO", ", radio: {control: fibre}"));
        Document none = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(none, "p"))
                .contains("130 sensor-drone pairs without a detection are not shown.")
                .contains("70 more sensor-drone pairs are not shown.");
        assertThat(texts(none, "td")).contains("always radio-silent (fibre); the closest approach was 50 m");

        Files.writeString(file, scene.toString().replace("RADIO", ", radio: {emission: cellular}"));
        Document other = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(other, "td"))
                .contains("always without an emission that the receiver can recognise; the closest approach was 50 m");

        Files.writeString(file, scene.toString().replace("RADIO", ", radio: {frequency: 10 GHz}"));
        Document elsewhere = parsed(report(new SceneFile(file), List.of()));
        assertThat(texts(elsewhere, "td"))
                .contains("always transmitting outside the receiver's frequency range; the closest approach was 50 m");
    }
}
