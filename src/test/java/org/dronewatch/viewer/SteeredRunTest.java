package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.dronewatch.examples.Chase;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.DroneMark;
import org.dronewatch.render.SiteState;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;

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
                                .satisfies(last -> assertThat(((Position) last).distance(here))
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

    /** The window's pane plays at full speed what another thread simulates. */
    @Test
    void theWindowFollowsTheRun() throws Exception {
        List<Throwable> failures = new ArrayList<>();
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> failures.add(failure));
        ViewerPane[] pane = new ViewerPane[1];
        SwingUtilities.invokeAndWait(() -> {
            pane[0] = new ViewerPane("chase", recording, 2);
            pane[0].addNotify();
            pane[0].setSize(900, 600);
            pane[0].validate();
            pane[0].playback().setSpeed(Double.POSITIVE_INFINITY);
            pane[0].playback().play();
        });
        try {
            new SceneRunner(new Chase()).listener(recording).run();
            recording.finish(true);
            long end = System.nanoTime() + 60_000_000_000L;
            double[] time = {0.0};
            while (time[0] < 30.0 && System.nanoTime() < end) {
                Thread.sleep(20);
                SwingUtilities.invokeAndWait(() -> time[0] = pane[0].playback().time());
            }
            assertThat(time[0]).isEqualTo(30.0);
            while (!pane[0].isIdle() && System.nanoTime() < end) {
                Thread.sleep(20);
            }
            assertThat(failures).isEmpty();
        } finally {
            SwingUtilities.invokeAndWait(() -> pane[0].close());
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }
}
