package org.dronewatch.viewer.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.swing.JCheckBox;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteSkin;
import org.dronewatch.report.coverage.CoverageSkin;
import org.dronewatch.run.RunInfo;
import org.dronewatch.setting.InputException;
import org.dronewatch.viewer.run.RecordedRun;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.ViewedRun;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The panel of coverage without a window: what it computes, shows and says is what the field says. */
class CoveragePanelTest {
    private static final long PATIENCE_NANOS = 60_000_000_000L;
    private static final String ROUND = FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s");
    private static final String SENSORS =
            ROUND + ROUND.replace("round", "short").replace("maxRange: 150", "maxRange: 40");

    @TempDir
    private Path directory;

    private FieldSite site;
    private CoveragePanel panel;
    private final AtomicReference<Optional<SiteSkin>> skin = new AtomicReference<>(Optional.empty());
    private final AtomicReference<Throwable> failure = new AtomicReference<>();

    private final SkinPainter painter = new SkinPainter() {
        @Override
        public void setSkin(Optional<SiteSkin> next) {
            skin.set(next);
        }

        @Override
        public boolean isPainting() {
            return false;
        }
    };

    @BeforeEach
    void open() throws Exception {
        site = FieldSite.in(directory, SENSORS);
        SensorLayout layout = new SensorLayout();
        layout.show(site.settings());
        panel = onEventThread(() -> new CoveragePanel(2, layout, settings -> LayerStore.NONE, painter, failure::set));
        RecordedRun run = new RecordedRun(new RunInfo(0, 1, site.settings()), site.stage());
        onEventThread(() -> {
            panel.show(new ViewedRun("boxes", run));
            panel.form().set("2, 12", "400", "20");
            return null;
        });
    }

    @AfterEach
    void close() {
        panel.close();
        assertThat(failure.get()).isNull();
    }

    private void settle(BooleanSupplier condition) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!onEventThread(() -> condition.getAsBoolean() && panel.isIdle())) {
            assertThat(System.nanoTime()).as("end of patience").isLessThan(end);
            Thread.sleep(10);
        }
        onEventThread(() -> null);
    }

    private void computed() throws Exception {
        onEventThread(() -> {
            panel.compute();
            return null;
        });
        settle(() -> panel.shown().isPresent());
    }

    private void switchOff(String sensor) throws Exception {
        onEventThread(() -> {
            panel.switches().boxes().stream()
                    .filter(box -> box.getText().equals(sensor))
                    .forEach(JCheckBox::doClick);
            return null;
        });
        settle(() -> panel.shown().orElseThrow().off().contains(sensor));
    }

    private FieldSummary expected(FieldGrid grid) {
        return FieldSummary.of(site.field(grid, 2), FieldCoverage.Choice.WORST, 0.5);
    }

    @Test
    void withoutASensorItShowsWhatTheReportStatesAsLost() throws Exception {
        computed();
        FieldGrid grid = panel.shown().orElseThrow().coverage().grid();
        FieldSummary summary = expected(grid);
        assertThat(grid.heights()).containsExactly(2.0, 12.0);
        assertThat(panel.shown().orElseThrow().remaining().covered())
                .isEqualTo(summary.heights().get(0).covered());
        SiteSkin whole = skin.get().orElseThrow();

        onEventThread(() -> {
            panel.heights().choose(1);
            return null;
        });
        settle(() -> panel.shown().orElseThrow().remaining().height() == 1);
        switchOff("round");
        int lost = summary.heights().get(1).lost().get("round");
        assertThat(lost).isPositive();
        assertThat(panel.shown().orElseThrow().remaining().lost()).isEqualTo(lost);
        assertThat(skin.get().orElseThrow()).isNotSameAs(whole);
        assertThat(panel.message()).startsWith("At 12 m, ").contains("without 'round'");
        assertThat(panel.shown().orElseThrow().legend().stream().map(CoverageSkin.LegendEntry::words))
                .anyMatch(words -> words.startsWith("no longer covered: "));

        onEventThread(() -> {
            panel.toggle();
            return null;
        });
        assertThat(skin.get()).isEmpty();
    }

    @Test
    void theHeadingIsThatOfTheForm() throws Exception {
        onEventThread(() -> {
            panel.form().setHeading(FieldHeading.INBOUND);
            return null;
        });
        computed();
        assertThat(panel.shown().orElseThrow().coverage().all().field().courses())
                .hasSize(1)
                .allMatch(course -> course.kind() == Course.Kind.INBOUND);
    }

    @Test
    void theCellUnderThePointerIsDescribedAndKeptWhenTheHeightChanges() throws Exception {
        computed();
        assertThat(panel.hint()).isEmpty();
        // North of the building, which is 30 m high.
        Position behind = new Position(0, 95, 0);
        onEventThread(() -> {
            panel.point(Optional.of(behind));
            return null;
        });
        settle(() -> true);
        assertThat(panel.hint()).contains("2 m above the ground: hidden by a building");
        assertThat(panel.cell())
                .startsWith("At 2 m above the ground: hidden by a building (building.obj). '")
                .contains("determines the cause: probability 0");
        onEventThread(() -> {
            panel.heights().choose(1);
            return null;
        });
        settle(() -> panel.shown().orElseThrow().remaining().height() == 1);
        settle(() -> true);
        assertThat(panel.cell()).startsWith("At 12 m above the ground: hidden by a building");
        onEventThread(() -> {
            panel.point(Optional.of(new Position(5000, 0, 0)));
            return null;
        });
        assertThat(panel.hint()).isEmpty();
    }

    @Test
    void aCancelledComputationLeavesThePanelUsable() throws Exception {
        onEventThread(() -> {
            panel.form().set("2, 12, 60", "400", "1");
            panel.compute();
            panel.cancel();
            return null;
        });
        settle(() -> true);
        boolean isWhole =
                panel.shown().isPresent() && panel.shown().get().coverage().isWhole();
        assertThat(isWhole).isFalse();
        assertThat(panel.message())
                .matches("The computation ended before any height was complete\\."
                        + "|.*Cancelled: complete for . of 3 heights\\.");
        onEventThread(() -> {
            panel.form().set("2", "400", "20");
            return null;
        });
        computed();
        assertThat(panel.shown().orElseThrow().coverage().isWhole()).isTrue();
    }

    @Test
    void whatIsNotPossibleIsSaidWithItsNameAndLimit() throws Exception {
        for (List<String> wrong : List.of(
                List.of("2", "400", "0", "cell"),
                List.of("30, 10", "400", "", "ascending order"),
                List.of("2, high", "400", "", "height high: 'high' is not a number"),
                List.of("2", "-5", "", "side"),
                List.of("2", "400", "0.1", "must be at most 2000"))) {
            onEventThread(() -> {
                panel.form().set(wrong.get(0), wrong.get(1), wrong.get(2));
                panel.compute();
                return null;
            });
            settle(() -> true);
            assertThat(panel.message()).contains(wrong.get(3)).doesNotContain("\n");
            assertThatExceptionOfType(InputException.class)
                    .isThrownBy(() -> panel.form().inputs());
        }
        assertThat(panel.shown()).isEmpty();
    }

    /** Cells of the grid of the panel are those of the command, so that either finds what the other has kept. */
    @Test
    void theDefaultsAreThoseOfTheCommand() throws Exception {
        onEventThread(() -> {
            panel.form().set("10, 30, 60, 120, 150", "500", "");
            return null;
        });
        CoverageForm.Inputs inputs = onEventThread(() -> panel.form().inputs());
        assertThat(inputs.grid()).isEqualTo(new FieldGrid(0, 0, 500, 5, FieldGrid.HEIGHTS));
        assertThat(inputs.heading()).isEqualTo(FieldHeading.WORST);
        assertThat(inputs.drone()).isEqualTo(FieldSite.DRONE);
    }
}
