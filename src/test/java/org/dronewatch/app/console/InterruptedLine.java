package org.dronewatch.app.console;

import java.util.ArrayList;
import java.util.List;

/** An interruption of a task when it has printed a given line. A task that prints many lines after it fails. */
public final class InterruptedLine implements AutoCloseable {
    private static final int MOST_AFTER = 100;

    private final String start;
    private final Runnable then;
    private final List<String> after = new ArrayList<>();
    private final Interruption interruption = new Interruption();
    private boolean isReached;

    private InterruptedLine(String start, Runnable then) {
        this.start = start;
        this.then = then;
    }

    /** An interruption of the calling thread after the first line that starts like this. */
    public static InterruptedLine after(String start) {
        return new InterruptedLine(start, () -> {});
    }

    /**
     * The same, but the thread is only told: something has noticed the interrupt and lets the rest finish, as the
     * search for routes does once it has one from the first direction.
     */
    public static InterruptedLine noticedAfter(String start) {
        return new InterruptedLine(start, Thread::interrupted);
    }

    /** Receives a line. */
    private void line(String line) {
        if (isReached) {
            after.add(line);
            if (after.size() > MOST_AFTER) {
                throw new AssertionError("goes on after the interruption: " + after);
            }
        } else if (line.startsWith(start)) {
            isReached = true;
            interruption.interruptCommand();
            then.run();
        }
    }

    /** The lines after the interruption. */
    public List<String> linesAfter() {
        return List.copyOf(after);
    }

    /** The interruption. */
    public Interruption interruption() {
        return interruption;
    }

    /** Shows each line of the task to this. */
    public TaskProgress shown() {
        return HeardProgress.of(this::line, () -> {});
    }

    /** Ends the task; the thread of the caller is not interrupted then. */
    @Override
    public void close() {
        interruption.close();
        Thread.interrupted();
    }
}
