package org.dronewatch.app;

import java.util.function.Consumer;

/** Prints notes while the scenes of a campaign are loaded; later ones concern single cases and are dropped. */
final class LoadingNotes {
    private final Consumer<String> notes;
    private volatile boolean isDone;

    LoadingNotes(Consumer<String> notes) {
        this.notes = notes;
    }

    void note(String line) {
        if (!isDone) {
            notes.accept(line);
        }
    }

    void done() {
        isDone = true;
    }
}
