package org.dronewatch.report.html;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.report.html.ReportPage.parsed;
import static org.dronewatch.report.html.ReportPage.report;
import static org.dronewatch.report.html.ReportPage.texts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.run.AlertResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** Reports of sweeps: a verdict over all runs. */
class SweepReportTest {
    @TempDir
    private Path directory;

    /** A quadrotor that comes from behind is seen too late; the verdict over the runs says so, and run 0 is not all. */
    @Test
    void theVerdictCoversAllRunsOfASweep() throws IOException {
        Document document = parsed(report(sweep(12), List.of(new Figure("site", new byte[] {1}))));

        String verdict = texts(document, "p").get(0);
        List<AlertResult> alerts = new SceneRunner(sweep(12)).run().alerts();
        long alerted = alerts.stream().filter(alert -> alert.time().isPresent()).count();
        long inTime =
                alerts.stream().filter(alert -> alert.inTime().orElse(false)).count();
        assertThat(inTime).isPositive().isLessThan(alerted);
        assertThat(alerted).isLessThan(12);
        assertThat(alerts.get(0).inTime()).as("run 0 alone looks well").contains(true);
        assertThat(verdict)
                .startsWith("In " + alerted
                        + " of 12 runs an alert is raised for every drone (not for bearing 30 deg, 60 deg")
                .contains("In " + inTime
                        + " of 12 runs the alert is in time, at least 4.5 s before the drone can reach the"
                        + " protected zone (not for bearing 30 deg")
                .endsWith("The worst run is run 1 (bearing 30 deg): 'quadrotor' is not detected by any sensor. No"
                        + " alert is raised.");
        NodeList folds = document.getElementsByTagName("details");
        assertThat(folds.getLength()).isEqualTo(12);
        for (int i = 0; i < folds.getLength(); i++) {
            Element fold = (Element) folds.item(i);
            assertThat(fold.hasAttribute("open")).as("fold %d", i).isEqualTo(i == 1);
            assertThat(fold.getElementsByTagName("summary").item(0).getTextContent())
                    .isEqualTo("Run " + i + " (bearing " + 30 * i + " deg)");
            assertThat(fold.getElementsByTagName("img").getLength()).isEqualTo(1);
            assertThat(fold.getElementsByTagName("svg").getLength()).isEqualTo(1);
            assertThat(fold.getElementsByTagName("table").getLength()).isGreaterThanOrEqualTo(2);
        }
        assertThat(texts(document, "p")).anyMatch(text -> text.endsWith("are measured clockwise from north."));
        assertThat(texts(document, "td")).as("no radians").noneMatch(text -> text.matches("bearing [0-9]\\.[0-9]+"));
    }

    /** A decoy that hovers in view all the time must make no run look better, and not worse either. */
    @Test
    void dronesThatDoNotAttackAreNotCountedOverRuns() throws IOException {
        sweep(12);
        Path file = directory.resolve("sweep.yaml");
        String decoy =
                """
                drones:
                  decoy:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [-30, 30, 150]}
                    label: {role: decoy}
                """;
        Files.writeString(file, Files.readString(file).replaceFirst("drones:\n", decoy));
        Document document = parsed(report(new SceneFile(file), List.of()));

        assertThat(texts(document, "p").get(0))
                .contains("of 12 runs an alert is raised for every attacking drone (not for bearing 30 deg")
                .contains("Only attacking drones are counted. The worst run is run 1 (bearing 30 deg)");
        List<String> cells = texts(document, "td");
        int row = cells.indexOf("bearing 30 deg");
        assertThat(cells.subList(row + 1, row + 7)).containsExactly("0 of 1", "-", "never", "-", "0 of 1", "never");
    }

    /** Memory and file stay in bounds: the first run and the worst are shown in full, each run has a row. */
    @Test
    void ofVeryManyRunsOnlyTheWorstAreShownInFull() throws IOException {
        Document document = parsed(report(sweep(36), List.of()));

        assertThat(texts(document, "summary")).hasSize(9).contains("Run 0 (bearing 0 deg)", "Run 9 (bearing 90 deg)");
        assertThat(texts(document, "p"))
                .anyMatch(text -> text.startsWith("The first run and the 8 worst of all 36 are detailed below"));
        assertThat(texts(document, "td").stream().filter(text -> text.matches("bearing \\d+ deg")))
                .hasSize(36);
    }

    /** A camera that looks north, with a drone that comes from all sides. */
    private Scene sweep(int count) throws IOException {
        Path file = directory.resolve("sweep.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: inbound, target: [0, 0, 145], bearing: 0 deg, distance: 100 m, standoff: 15 m}
                    speed: 10 m/s
                sensors:
                  west: {kind: camera, position: [0, 0, 145], aim: {azimuth: -50 deg, elevation: 5 deg}, fov: 120 deg, fovAxis: horizontal, rate: 2}
                alert: {protect: {centre: [0, 0, 145], radius: 10 m}, response: 4.5 s}
                run: {duration: 9}
                sweep: {parameter: drones.quadrotor.flight.bearing, from: 0 deg, to: LAST deg, count: COUNT}
                """
                        .replace("LAST", Integer.toString(360 - 360 / count))
                        .replace("COUNT", Integer.toString(count)));
        return new SceneFile(file);
    }
}
