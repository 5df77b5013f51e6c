package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.viewer.ShownWindow;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** In the real window, on a display. */
class WatchedRunWindowTest {
    /** The first seconds of the gate watch. */
    static class BriefWatch extends GateWatch {
        @Override
        protected void build() {
            super.build();
            setRun(RunSettings.DEFAULT.withDuration(2.0));
        }
    }

    @Test
    @Timeout(value = 2, unit = TimeUnit.MINUTES)
    void theRunIsShownUntilTheUserClosesTheWindow() throws Exception {
        assumeTrue(Viewer.obstacle().isEmpty(), "needs a display");
        FutureTask<SceneResult> watching = new FutureTask<>(() -> WatchedRun.watch(new BriefWatch()));
        Thread thread = new Thread(watching);
        thread.setDaemon(true);
        thread.start();
        ShownWindow.awaitFinished();
        String title = onEventThread(() -> ShownWindow.frame().orElseThrow().getTitle());
        assertThat(watching.isDone()).isFalse();
        ShownWindow.close();
        SceneResult result = watching.get();

        assertThat(title).isEqualTo("brief-watch - dronewatch");
        assertThat(onEventThread(ShownWindow::frame)).isEmpty();
        assertThat(result.complete()).isTrue();
        assertThat(result.runs())
                .as("the results without a window")
                .isEqualTo(new BriefWatch().run().runs());
    }
}
