package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarFalseAlarms;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** False alarms are kept apart from drones: what sensors measure of these stays the same, byte for byte. */
class FalseAlarmsApartTest {
    private static final Position PLACE = new Position(0, 0, 30);

    @TempDir
    private Path directory;

    private static final class Site extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final boolean nervous;

        Site(boolean nervous) {
            this.nervous = nervous;
        }

        @Override
        protected void build() {
            loadFloor();
            Position start = new Position(0, 400, 60);
            DroneSettings drone = DroneSettings.of(
                            loadPackaged("quadrotor.obj"), new FlightPathSettings.Approach(start, PLACE))
                    .withRadar(RadarSignature.DEFAULT.withFluctuation(RadarSignature.Fluctuation.SWERLING_1));
            add("first", drone);
            add("second", drone);
            RadarSettings radar = RadarSettings.at(PLACE, LinkBudget.DataSheet.of(300, 0.01))
                    .withDetection(new RadarDetection.Chance(1e-3, 1));
            CameraSettings camera =
                    CameraSettings.at(PLACE).withLookAt(start).withDetection(TargetTask.DEFAULT.withChance(true));
            ThermalSettings thermal =
                    ThermalSettings.at(PLACE).withLookAt(start).withChance(true);
            AcousticSettings microphone = AcousticSettings.at(PLACE).withRate(2);
            RfSettings radio = RfSettings.at(PLACE);
            FalseAlarms often = new FalseAlarms(5400, 4, 0.5);
            add("radar", nervous ? radar.withFalseAlarms(RadarFalseAlarms.DEFAULT.withCells(3000)) : radar);
            add("camera", nervous ? camera.withFalseAlarms(often) : camera);
            add("thermal", nervous ? thermal.withFalseAlarms(often) : thermal);
            add("microphone", nervous ? microphone.withFalseAlarms(often) : microphone);
            add("radio", nervous ? radio.withFalseAlarms(often) : radio);
            setAlert(AlertSettings.DEFAULT.withConfirmation(2, 4));
            setRun(RunSettings.DEFAULT.withDuration(8));
        }
    }

    private SceneResult run(boolean nervous, int threads, Path target) {
        Site scene = new Site(nervous);
        try (RunReport report = new RunReport(scene, target, true)) {
            SceneResult result =
                    new SceneRunner(scene).threads(threads).listener(report).run();
            report.finish(result);
            return result;
        }
    }

    private static List<String> ofDrones(Path file) throws IOException {
        return Files.readAllLines(file).stream()
                .filter(row -> row.startsWith("run,") || row.contains(",first,") || row.contains(",second,"))
                .toList();
    }

    @Thorough
    @Test
    void whatIsMeasuredOfDronesStaysTheSame() throws IOException {
        Path calm = directory.resolve("calm");
        Path nervous = directory.resolve("nervous");
        SceneResult without = run(false, 2, calm);
        SceneResult with = run(true, 4, nervous);

        for (String table : List.of("detections.csv", "observations.csv")) {
            List<String> rows = Files.readAllLines(nervous.resolve(table));
            assertThat(ofDrones(nervous.resolve(table)))
                    .hasSizeGreaterThan(5)
                    .isEqualTo(Files.readAllLines(calm.resolve(table)))
                    .hasSizeLessThan(rows.size() - 20);
        }
        assertThat(Files.readString(nervous.resolve("flights.csv")))
                .isEqualTo(Files.readString(calm.resolve("flights.csv")));
        assertThat(with.pairs()).isEqualTo(without.pairs());
        // Contacts have other numbers, since those of false alarms come between them.
        for (String drone : List.of("first", "second")) {
            assertThat(with.alert(drone).time())
                    .isPresent()
                    .isEqualTo(without.alert(drone).time());
            assertThat(with.alert(drone).sensors())
                    .isEqualTo(without.alert(drone).sensors());
        }
        assertThat(with.runs().get(0).falseAlarms().counted().keySet())
                .containsExactlyInAnyOrder("radar", "camera", "thermal", "microphone", "radio");
        assertThat(with.runs().get(0).falseAlarms().alerts()).isNotEmpty();
        assertThat(without.runs().get(0).falseAlarms().count()).isZero();
        assertThat(Files.readString(calm.resolve("result.json"))).doesNotContain("false_alarms");
        falseAlarmsAreRowsOfTheirOwn(with, nervous);

        run(true, 1, directory.resolve("alone"));
        for (String file : List.of("detections.csv", "observations.csv", "result.json")) {
            assertThat(Files.readString(directory.resolve("alone").resolve(file)))
                    .isEqualTo(Files.readString(nervous.resolve(file)));
        }
    }

    private static void falseAlarmsAreRowsOfTheirOwn(SceneResult result, Path target) throws IOException {
        List<String> rows = Files.readAllLines(target.resolve("detections.csv")).stream()
                .filter(row -> row.contains(",false,"))
                .toList();
        assertThat(rows).hasSize((int) result.runs().get(0).falseAlarms().count());
        assertThat(rows).anyMatch(row -> row.matches("0,\\d+,false,radar,radar,,[\\d.]+,[\\d.]+,[\\d.]+,dB,\\d+"));
        assertThat(rows).anyMatch(row -> row.matches("0,[\\d.]+,false,radio,rf,,,6,6,dB,[\\d.]+"));
        // The letters may also be among those of a picture.
        String words =
                Files.readString(target.resolve("report.html")).replaceAll("data:image/[a-z]+;base64,[^\"]*", "");
        assertThat(words)
                .contains("False alerts with this rule: ", "false alerts per day", "2 of 4 (this rule)")
                .doesNotContain("NaN");
        assertThat(Files.readString(target.resolve("result.json")))
                .containsPattern("\"false_alarms\" : \\[ \\{\\s+\"run\" : 0,\\s+\"per_day\" : \\d")
                .contains("\"confirmations\"");
    }
}
