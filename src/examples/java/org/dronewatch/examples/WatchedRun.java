package org.dronewatch.examples;

import java.util.concurrent.CancellationException;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.Viewer;

/** A run that is watched in the window of the viewer, on a display. */
public final class WatchedRun {
    private WatchedRun() {}

    /**
     * Opens the window, runs the scene, and waits until the user closes the window, which also ends the run.
     *
     * @throws CancellationException if the window is closed while the models are still being loaded
     */
    public static SceneResult watch(Scene scene) {
        SceneRunner runner = new SceneRunner(scene);
        try (Viewer viewer = Viewer.open(scene, runner, 2)) {
            runner.listener(viewer.listener()).cancelWhen(viewer::isClosed);
            SceneResult result = runner.run();
            viewer.finished(result.complete());
            viewer.awaitClosed();
            return result;
        }
    }

    public static void main(String[] args) {
        watch(new GateWatch());
    }
}
