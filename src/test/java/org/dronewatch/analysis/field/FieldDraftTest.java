package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A complete draft is the field that is assessed from nothing; a fine one has its borders. */
class FieldDraftTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 400, 25, List.of(2.0, 12.0));

    @TempDir
    private Path directory;

    private FieldSite site;
    private FieldRequest request;
    private DetectionField field;

    private void assess(String sensors, FieldGrid grid, FieldHeading heading) throws Exception {
        site = FieldSite.in(directory, sensors);
        request = request(site.settings(), grid, heading);
        field = fresh(request);
    }

    private FieldRequest request(SceneSettings settings) {
        return request(settings, GRID, FieldHeading.WORST);
    }

    private FieldRequest request(SceneSettings settings, FieldGrid grid, FieldHeading heading) {
        List<Course> courses = heading.courses(settings, site.stage(), FieldSite.DRONE, grid);
        return new FieldRequest(
                settings,
                site.stage(),
                FieldSite.DRONE,
                grid,
                courses,
                FieldCoverage.Choice.WORST,
                FieldTerms.ONE_LOOK,
                0.5);
    }

    private static DetectionField fresh(FieldRequest asked) {
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> FieldAssessment.of(asked, LayerStore.NONE, cells -> {}));
        }
    }

    private static SceneSettings moved(SceneSettings settings, String id, double east, double north) {
        SensorSettings<?> sensor = settings.sensors().get(id);
        return settings.withSensor(id, sensor.withPosition(sensor.position().plus(new Position(east, north, 0.0))));
    }

    private FieldDraft begun(SceneSettings moved, int height) {
        FieldDraft draft = new FieldDraft(request, field, height, moved);
        draft.begin();
        return draft;
    }

    private static void refine(FieldDraft draft) {
        while (!draft.isFine()) {
            draft.refine(() -> false);
        }
    }

    private static void assertEqual(DetectionField drawn, DetectionField whole, int height) {
        assertThat(drawn.courses()).isEqualTo(whole.courses());
        assertThat(drawn.sensors()).isEqualTo(whole.sensors());
        List<String> different = new ArrayList<>();
        for (int sensor = 0; sensor < whole.sensors().size(); sensor++) {
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                for (int course = 0; course < whole.courses().size(); course++) {
                    boolean isSame = drawn.step(sensor, 0, column, row, course)
                                    == whole.step(sensor, height, column, row, course)
                            && drawn.cause(sensor, 0, column, row, course)
                                    == whole.cause(sensor, height, column, row, course)
                            && drawn.margin(sensor, 0, column, row, course)
                                    .equals(whole.margin(sensor, height, column, row, course));
                    if (!isSame) {
                        different.add(whole.sensors().get(sensor) + " " + column + " " + row + " " + course);
                    }
                }
            }
        }
        assertThat(different).isEmpty();
    }

    /** The radar takes courses with it, on which the others have to be assessed, too. */
    @Thorough
    @Test
    void aCompleteDraftIsTheFieldOfTheMovedSensors() throws Exception {
        assess(FieldSite.ALL, GRID, FieldHeading.WORST);
        SceneSettings moved = moved(moved(site.settings(), "round", 37.0, -21.0), "eye", -12.0, 8.0);
        Aimed heat = moved.sensors().get("heat").as(Aimed.class).orElseThrow();
        moved = moved.withSensor("heat", heat.withAim(new Aim.Direction(1.0, 0.1)));
        assertThat(FieldDraft.movedSensors(field, moved)).containsExactly("round", "eye", "heat");
        DetectionField whole = fresh(request(moved));
        for (int height = 0; height < 2; height++) {
            FieldDraft draft = begun(moved, height);
            refine(draft);
            assertThat(draft.isComplete()).isFalse();
            draft.complete(() -> false);
            assertThat(draft.isComplete()).isTrue();
            assertThat(draft.reduced()).isEmpty();
            assertEqual(draft.field(), whole, height);
        }
    }

    @Thorough
    @Test
    void aFineDraftHasTheBordersOfWhatIsCovered() throws Exception {
        FieldGrid grid = new FieldGrid(0, 0, 400, 4, List.of(2.0));
        assess(FieldSite.ROUND, grid, FieldHeading.INBOUND);
        SceneSettings moved = moved(site.settings(), "round", 37.0, -21.0);
        FieldDraft draft = begun(moved, 0);
        assertThat(draft.assessed()).isLessThanOrEqualTo(64);
        refine(draft);
        assertThat(draft.assessed()).isLessThan(grid.cells() / 3);
        DetectionField whole = fresh(new FieldRequest(
                moved, site.stage(), FieldSite.DRONE, grid, request.courses(), request.choice(), request.terms(), 0.5));
        DetectionField fine = draft.field();
        int wrong = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            wrong += fine.covers(0, 0, column, row, 0, 0.5) == whole.covers(0, 0, column, row, 0, 0.5) ? 0 : 1;
        }
        // What is smaller than the first blocks, and in none of the cells that were looked at, is missed.
        assertThat(wrong).isLessThan(grid.cells() / 200);
    }

    @Test
    void whatIsOutdatedRemainsIncomplete() throws Exception {
        assess(FieldSite.ROUND, GRID, FieldHeading.WORST);
        FieldDraft draft = begun(moved(site.settings(), "round", 37.0, -21.0), 1);
        refine(draft);
        int before = draft.assessed();
        draft.complete(() -> true);
        assertThat(draft.isComplete()).isFalse();
        assertThat(draft.assessed()).isEqualTo(before);
        draft.complete(() -> false);
        assertThat(draft.isComplete()).isTrue();
    }

    @Test
    void nothingIsAssessedWhereNothingWasMoved() throws Exception {
        assess(FieldSite.ROUND, GRID, FieldHeading.WORST);
        FieldDraft draft = begun(site.settings(), 0);
        assertThat(draft.isFine()).isTrue();
        draft.complete(() -> false);
        assertThat(draft.assessed()).isZero();
        assertEqual(draft.field(), field, 0);
    }
}
