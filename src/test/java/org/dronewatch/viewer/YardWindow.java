package org.dronewatch.viewer;

import static org.dronewatch.viewer.EventThread.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.SceneRunner;

/** A window with a second of the yard, whose run is over and whose site is drawn. */
final class YardWindow {
    private YardWindow() {}

    /** Opens it; skips the test where no window can be. */
    static Viewer open(Path directory) throws Exception {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
        Yard yard = new Yard(directory);
        SceneRunner runner = new SceneRunner(yard).set("run.duration", "1 s");
        Viewer viewer = Viewer.open(yard, runner, 2, directory.resolve("viewer.properties"));
        runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
        viewer.finished(true);
        await(
                "the site",
                () -> viewer.pane().viewed().isPresent()
                        && viewer.pane().world().image() != null);
        return viewer;
    }
}
