package org.dronewatch.app.console;

import java.util.function.Consumer;

/** Prints notes while the scenes of a campaign are loaded; notes after that concern single cases and are dropped. */
public final class LoadingNotes {
    private final Consumer<String> notes;
    private volatile boolean isDone;

    public LoadingNotes(Consumer<String> notes) {
        this.notes = notes;
    }

    public void note(String line) {
        if (!isDone) {
            notes.accept(line);
        }
    }

    public void done() {
        isDone = true;
    }
}
