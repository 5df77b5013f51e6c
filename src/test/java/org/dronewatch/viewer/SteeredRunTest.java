package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.dronewatch.examples.Chase;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.run.Recording;
import org.dronewatch.viewer.run.ViewedRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run with a steered drone is shown while it goes on: as far as it has flown, and no farther. */
class SteeredRunTest {
    private final Recording recording = new Recording();

    private static DroneMark guard(ViewedRun viewed, double time) {
        SiteState state = viewed.state(time, Optional.empty(), Optional.empty());
        return state.drones().stream()
                .filter(mark -> mark.drone().id().equals("guard"))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void whatHasBeenFlownIsDrawn() {
        List<ViewedRun> viewed = new ArrayList<>();
        List<Position> places = new ArrayList<>();
        List<AABB> frames = new ArrayList<>();
        new SceneRunner(new Chase())
                .listener(recording)
                .listener(new SceneListener() {
                    @Override
                    public void runStarted(RunInfo run, Stage stage) {
                        viewed.add(new ViewedRun("chase", recording.runs().get(0)));
                        frames.add(viewed.get(0).picture().frame());
                    }

                    @Override
                    public void observed(Frame frame) {
                        DroneMark mark = guard(viewed.get(0), frame.time());
                        Position here = mark.drone().origin();
                        assertThat(mark.flown().get(mark.flown().size() - 1)).isEqualTo(here);
                        assertThat(mark.toCome()).containsOnly(here);
                        places.add(here);
                        assertThat(guard(viewed.get(0), 0.5 * frame.time()).toCome())
                                .last()
                                .satisfies(last -> assertThat((last).distance(here))
                                        .as("at most a sample behind")
                                        .isLessThan(20.0 * 30.0 / 600 + 1e-9));
                    }
                })
                .run();
        recording.finish(true);

        DroneMark whole = guard(viewed.get(0), 0.0);
        assertThat(whole.toCome()).hasSize(601);
        assertThat(whole.toCome().get(600)).isEqualTo(places.get(places.size() - 1));
        assertThat(frames.get(0).maxX())
                .isLessThan(viewed.get(0).picture().frame().maxX());
    }

    /** In a window that is open while another thread simulates, and at any time afterwards. */
    @Test
    void theWindowFollowsTheRun(@TempDir Path directory) throws Exception {
        assumeTrue(Viewer.obstacle().isEmpty(), "needs a display");
        Chase chase = new Chase();
        SceneRunner runner = new SceneRunner(chase);
        try (Viewer viewer = Viewer.open(chase, runner, 2, directory.resolve("viewer.properties"))) {
            runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
            viewer.finished(true);
            ViewerPane pane = viewer.pane();
            await("the site is there", () -> pane.viewed().isPresent());
            for (double time : new double[] {30.0, 12.0, 0.0}) {
                SwingUtilities.invokeAndWait(() -> {
                    pane.playback().pause();
                    pane.playback().jump(time);
                });
                await("drawn at " + time, () -> pane.world().image() != null && pane.isIdle());
                assertThat(pane.playback().time()).isEqualTo(time);
            }
        }
    }

    private static void await(String what, BooleanSupplier condition) throws Exception {
        long end = System.nanoTime() + 60_000_000_000L;
        boolean[] holds = new boolean[1];
        while (!holds[0]) {
            assertThat(System.nanoTime()).as(what).isLessThan(end);
            Thread.sleep(20);
            SwingUtilities.invokeAndWait(() -> holds[0] = condition.getAsBoolean());
        }
    }
}
