package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import org.dronewatch.parallel.Workers;

/**
 * Runs the cases of a campaign in chunks of neighbouring cases. Each chunk is handed over whole, so that an
 * interrupted campaign can be resumed: chunks that were kept are not run again.
 */
public final class CampaignRun {
    /** Cases of a chunk: some seconds of work, and few files. */
    public static final int CHUNK = 50;

    private final CampaignPlan plan;

    /** Where the results of chunks are kept. */
    public interface Chunks {
        /** Whether a chunk's results are there. */
        boolean has(int chunk);

        /**
         * Keeps the results of a chunk, all or none of them.
         *
         * @param results by case, then variant
         */
        void put(int chunk, List<CaseResult> results);
    }

    public CampaignRun(CampaignPlan plan) {
        this.plan = plan;
    }

    /** The number of chunks. */
    public int chunks() {
        return (plan.settings().runs() + CHUNK - 1) / CHUNK;
    }

    /**
     * Runs what is missing, on the calling {@link Workers}; the same results for any number of them.
     *
     * @param progress receives the number of cases done since the last call, including those of chunks that were
     *     kept; from any thread
     * @throws java.util.concurrent.CancellationException when the thread is interrupted: the chunks that are whole are
     *     kept
     */
    public void run(Chunks kept, IntConsumer progress) {
        for (int chunk = 0; chunk < chunks(); chunk++) {
            int first = chunk * CHUNK;
            int cases = Math.min(CHUNK, plan.settings().runs() - first);
            if (kept.has(chunk)) {
                progress.accept(cases);
            } else {
                kept.put(chunk, results(first, cases, progress));
            }
        }
    }

    private List<CaseResult> results(int first, int cases, IntConsumer progress) {
        List<String> variants = plan.variants();
        CaseResult[] results = new CaseResult[cases * variants.size()];
        Workers.forEach(cases, i -> {
            // Cases are what is distributed: within one, loops stay on its thread.
            try (Workers alone = new Workers(1)) {
                for (int v = 0; v < variants.size(); v++) {
                    String variant = variants.get(v);
                    results[i * variants.size() + v] = alone.call(() -> CaseRun.of(plan, first + i, variant));
                }
            }
            progress.accept(1);
        });
        return new ArrayList<>(Arrays.asList(results));
    }
}
