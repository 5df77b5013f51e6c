package org.dronewatch.sensor.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/** Runs one piece of work on several threads at once. */
final class Helpers {

    private Helpers() {}

    /** Runs the work on so many threads, the caller's among them, and waits for all; a failure of any surfaces here. */
    static void runOnThreads(Runnable work, int threads) {
        List<CompletableFuture<Void>> others = new ArrayList<>();
        for (int i = 1; i < threads; i++) {
            others.add(CompletableFuture.runAsync(work, task -> new Thread(task, "static-view").start()));
        }
        work.run();
        try {
            others.forEach(CompletableFuture::join);
        } catch (CompletionException e) {
            throw e.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(e.getCause());
        }
    }
}
