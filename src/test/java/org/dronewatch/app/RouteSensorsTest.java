package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What {@code route} prints of a scene to which sensors are added, one after the other, or in another order. */
class RouteSensorsTest {
    private static final String ZONE = "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 3 s}\n";

    private static final List<String> SENSORS = List.of(
            FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s"),
            "  slow: {kind: radar, position: [-40, 5, 4], rate: 0.2, minRange: 1, maxRange: 300, elevationWidth: 90 deg,"
                    + " budget: {range: 90, crossSection: 0.01}, minSpeed: 0 m/s, detection: {kind: chance, pulses: 8}}\n",
            "  radio: {kind: rf, position: [0, 5, 4], threshold: 30}\n",
            "  heat: {kind: thermal, position: [0, 0, 4], fov: 40 deg, aim: {azimuth: 90 deg, elevation: 5 deg}}\n",
            "  turning: {kind: camera, position: [3, 0, 4], fov: 30 deg, width: 640, height: 480, rate: 2,"
                    + " positioner: {cues: [round], search: {kind: sweep, width: 200 deg, speed: 60 deg/s}}}\n");

    @TempDir
    private Path directory;

    private List<String> table(List<String> sensors) throws IOException {
        FieldSite.in(directory, String.join("", sensors) + ZONE);
        Outcome outcome = Program.run(
                "route",
                directory.resolve("site.yaml").toString(),
                "--side=400",
                "--cell=40",
                "--heights=10,45",
                "--quiet");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out().lines().toList();
    }

    /** By direction, in the column of that name; what is below 0.001 counts as 0. */
    private static double[] exposures(List<String> table) {
        int end = table.get(1).indexOf("exposure") + "exposure".length();
        return table.subList(2, 10).stream()
                .map(row -> row.substring(end - "exposure".length(), end).strip())
                .mapToDouble(text -> text.startsWith("<") ? 0.0 : Double.parseDouble(text))
                .toArray();
    }

    /** Within 2 %, since in cells of 40 m the smoothing of a route may get further in one of two fields. */
    @Thorough
    @Test
    void anotherSensorNeverLowersTheExposureAndTheirOrderChangesNothing() throws IOException {
        double[] before = new double[8];
        List<String> sensors = SENSORS.subList(0, LongForm.count(3, SENSORS.size()));
        for (int count = 1; count <= sensors.size(); count++) {
            double[] now = exposures(table(sensors.subList(0, count)));
            for (int sector = 0; sector < 8; sector++) {
                assertThat(now[sector])
                        .as("%d sensors, sector %d", count, sector)
                        .isGreaterThanOrEqualTo(0.98 * before[sector]);
            }
            before = now;
        }
        for (double exposure : before) {
            assertThat(exposure).isPositive();
        }
        List<String> reversed = new ArrayList<>(sensors);
        Collections.reverse(reversed);
        assertThat(table(reversed)).isEqualTo(table(sensors));
    }
}
