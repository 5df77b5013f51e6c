package org.dronewatch.viewer;

import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFrame;

/** The window that is on the display, as its user finds and closes it. */
public final class ShownWindow {
    private ShownWindow() {}

    /** The window; empty until there is one. For the event thread. */
    public static Optional<JFrame> frame() {
        return Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst();
    }

    /** What it shows of a scene; empty until it does. For the event thread. */
    static Optional<ViewerPane> pane() {
        return frame().flatMap(frame -> find(frame, ViewerPane.class));
    }

    /** The first part of a type in a component. For the event thread. */
    static <T> Optional<T> find(Component part, Class<T> type) {
        if (type.isInstance(part)) {
            return Optional.of(type.cast(part));
        }
        return part instanceof Container inside
                ? Stream.of(inside.getComponents())
                        .flatMap(one -> find(one, type).stream())
                        .findFirst()
                : Optional.empty();
    }

    /** Waits until there is a window. */
    public static void awaitShown() throws Exception {
        await("the window", () -> frame().isPresent());
    }

    /** Waits until there is a window, and the run in it is over. */
    public static void awaitFinished() throws Exception {
        await("the end of the run", () -> pane().filter(pane -> pane.recording().isFinished())
                .isPresent());
    }

    /** Closes the window. */
    public static void close() throws Exception {
        onEventThread(() -> {
            JFrame frame = frame().orElseThrow();
            frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
            return null;
        });
    }
}
