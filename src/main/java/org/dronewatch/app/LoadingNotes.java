package org.dronewatch.app;

import java.io.PrintWriter;

/** Prints notes while the scenes of a campaign are loaded; later ones concern single cases and are dropped. */
final class LoadingNotes {
    private final PrintWriter err;
    private volatile boolean isDone;

    LoadingNotes(PrintWriter err) {
        this.err = err;
    }

    void note(String line) {
        if (!isDone) {
            err.println(line);
        }
    }

    void done() {
        isDone = true;
    }
}
