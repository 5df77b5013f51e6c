package org.dronewatch.app.console;

import java.util.function.Consumer;

/** Prints notes while the scenes of a campaign are loaded; notes after that concern single cases and are dropped. */
public final class LoadingNotes {
    private final Consumer<String> notes;
    private volatile boolean isDone;

    /**
     * Prints notes until {@link #done} is called.
     *
     * @param notes receives the notes, one line each
     */
    public LoadingNotes(Consumer<String> notes) {
        this.notes = notes;
    }

    /** Prints a note, unless loading is over. */
    public void note(String line) {
        if (!isDone) {
            notes.accept(line);
        }
    }

    /** Records that loading is over. */
    public void done() {
        isDone = true;
    }
}
