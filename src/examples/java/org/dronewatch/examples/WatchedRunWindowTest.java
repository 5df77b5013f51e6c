package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Window;
import java.awt.event.WindowEvent;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
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

    private static <T> T onEventThread(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        return task.get();
    }

    private static Optional<JFrame> frame() {
        return Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst();
    }

    /** Whether a thread waits for the user to close the window: the run has ended. */
    private static boolean isWaiting(Thread thread) {
        return Stream.of(thread.getStackTrace())
                .anyMatch(call -> call.getMethodName().equals("awaitClosed"));
    }

    @Test
    @Timeout(value = 2, unit = TimeUnit.MINUTES)
    void theRunIsShownUntilTheUserClosesTheWindow() throws Exception {
        assumeTrue(Viewer.obstacle().isEmpty(), "needs a display");
        FutureTask<SceneResult> watching = new FutureTask<>(() -> WatchedRun.watch(new BriefWatch()));
        Thread thread = new Thread(watching);
        thread.setDaemon(true);
        thread.start();
        while (thread.isAlive() && !isWaiting(thread)) {
            Thread.sleep(20);
        }
        if (watching.isDone()) {
            fail("the run ended before its window: %s", watching.get());
        }
        String title = onEventThread(() -> frame().orElseThrow().getTitle());
        onEventThread(() -> {
            JFrame window = frame().orElseThrow();
            window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
            return null;
        });
        SceneResult result = watching.get();

        assertThat(title).isEqualTo("brief-watch - dronewatch");
        assertThat(onEventThread(WatchedRunWindowTest::frame)).isEmpty();
        assertThat(result.complete()).isTrue();
        assertThat(result.runs())
                .as("the results without a window")
                .isEqualTo(new BriefWatch().run().runs());
    }
}
