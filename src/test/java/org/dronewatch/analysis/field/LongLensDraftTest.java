package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;

/**
 * The camera with a long lens in the scene {@code monaco}, moved: its field has the borders of what it covers after a
 * fraction of its cells, and is what pictures of the drone give, in which all pixels are counted.
 */
class LongLensDraftTest {
    private static final String CAMERA = "camera";
    private static final int LOOKS = 150;

    @Thorough
    @Test
    void aMovedCameraSeesWhatItsPicturesShow() {
        long seed = System.nanoTime();
        System.out.println("LongLensDraftTest: seed " + seed);
        PackagedSite site =
                PackagedSite.of("scenes/monaco.yaml", "from-the-sea", 400, 5, "30", FieldTerms.ONE_LOOK, CAMERA, null);
        SensorSettings<?> sensor = site.sensor(CAMERA);
        SceneSettings moved = site.settings()
                .withSensor(CAMERA, sensor.withPosition(sensor.position().plus(new Position(2.4, 5.6, 0.0))));
        DetectionField field = site.field();
        FieldRequest before = new FieldRequest(
                site.settings(),
                site.stage(),
                "from-the-sea",
                field.grid(),
                field.courses(),
                FieldCoverage.Choice.WORST,
                FieldTerms.ONE_LOOK,
                FieldCoverage.DEFAULT_COVERED);
        FieldDraft draft = new FieldDraft(before, field, 0, moved);
        try (Workers workers = new Workers(2)) {
            workers.call(() -> {
                draft.begin();
                while (!draft.isFine()) {
                    draft.refine(() -> false);
                }
                assertThat(draft.assessed()).isLessThan(field.grid().cells() / 3);
                DetectionField fine = draft.field();
                draft.complete(() -> false);
                assertThat(different(fine, draft.field()))
                        .isLessThan(field.grid().cells() / 200);
                return null;
            });
        }
        compare(site, moved, draft.field(), seed);
    }

    /** In how many cells another worst course is covered. */
    private static int different(DetectionField fine, DetectionField whole) {
        int count = 0;
        int courses = whole.courses().size();
        for (int cell = 0; cell < whole.grid().cells(); cell++) {
            int column = whole.grid().column(cell);
            int row = whole.grid().row(cell);
            boolean isDifferent = false;
            for (int course = 0; course < courses && whole.isOpen(0, column, row); course++) {
                isDifferent |=
                        fine.covers(0, 0, column, row, course, 0.5) != whole.covers(0, 0, column, row, course, 0.5);
            }
            count += isDifferent ? 1 : 0;
        }
        return count;
    }

    private static void compare(PackagedSite site, SceneSettings moved, DetectionField drawn, long seed) {
        SensorSettings<?> sensor = moved.sensors().get(CAMERA);
        Assessor pictures = new Assessor(CAMERA, sensor, site.stage().world());
        List<PackagedSite.Cell> cells = site.cells(LOOKS, new Random(seed));
        for (PackagedSite.Cell cell : cells) {
            Drone there = site.at(cell);
            Pointing pointing = Mounted.turnedTo(sensor, there.origin()).orElseThrow();
            Assessment exact = pictures.assess(there, Optional.of(pointing), new Random(1));
            String where = "seed %d, %s at %s".formatted(seed, cell, there.origin());
            assertThat(drawn.cause(0, 0, cell.column(), cell.row(), cell.course()))
                    .as(where)
                    .isEqualTo(exact.cause());
            assertThat(drawn.probability(0, 0, cell.column(), cell.row(), cell.course()))
                    .as(where)
                    .isEqualTo(exact.signal().probability());
        }
    }
}
