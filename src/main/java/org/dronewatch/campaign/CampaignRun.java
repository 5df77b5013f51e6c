package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.PrimitiveIterator;
import java.util.stream.IntStream;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.Shard;
import org.dronewatch.parallel.Workers;

/**
 * Runs the cases of a campaign in chunks of consecutive cases. The results of each chunk are kept as a whole ({@link
 * Chunks}), so that an interrupted campaign can be resumed: chunks that were kept are not run again. If the outcomes
 * decide how many cases there are, they are considered in the order of the cases; some cases of the last chunk may then
 * be superfluous.
 */
public final class CampaignRun {
    /** Number of cases in a chunk: a few seconds of work, and few files. */
    public static final int CHUNK = 50;

    private final CampaignPlan plan;
    private final Cases cases;
    private final Shard shard;

    /** Where the results of chunks are kept. */
    public interface Chunks {
        /** The results of a chunk, by case, then variant; empty if they have not been kept. */
        Optional<List<CaseResult>> find(int chunk);

        /**
         * Keeps the results of a chunk, all or none of them.
         *
         * @param results the results by case, then variant
         */
        void put(int chunk, List<CaseResult> results);
    }

    /** Receives the progress, from any thread. */
    @FunctionalInterface
    public interface Progress {
        /** Receives the number of further cases that have been run. */
        void ran(int cases);

        /** Receives the number of further cases whose results had been kept before. */
        default void kept(int cases) {
            ran(cases);
        }
    }

    /** A run of the cases of a campaign. */
    public CampaignRun(CampaignPlan plan) {
        this(plan, plan);
    }

    /** A run of other cases of the same variants, such as those that show which settings matter. */
    public CampaignRun(CampaignPlan plan, Cases cases) {
        this(plan, cases, Shard.ALL);
    }

    /** A run of some of the cases. */
    public CampaignRun(CampaignPlan plan, Cases cases, Shard shard) {
        this.plan = plan;
        this.cases = cases;
        this.shard = shard;
    }

    /** The campaign. */
    public CampaignPlan plan() {
        return plan;
    }

    /** What is run: the campaign itself, or other cases of its variants. */
    public Cases cases() {
        return cases;
    }

    /** Whether the outcomes decide how many cases there are. */
    public boolean endsByOutcomes() {
        return cases == plan && plan.settings().until().isPresent();
    }

    /** What decides when the campaign ends, before any case has been added. */
    public Stopping stopping() {
        return cases == plan ? new Stopping(plan) : new Stopping(cases);
    }

    /** The number of cases that are run; the largest number if the outcomes decide how many there are. */
    public int size() {
        return chunks().map(this::size).sum();
    }

    /** The numbers of the chunks that are run, in their order. */
    public IntStream chunks() {
        return IntStream.range(0, chunks(cases)).filter(shard::has);
    }

    /** The number of cases in a chunk. */
    public int size(int chunk) {
        return Math.min(CHUNK, cases.size() - chunk * CHUNK);
    }

    /** The number of chunks; the largest number if the outcomes decide how many cases there are. */
    public static int chunks(Cases cases) {
        return (cases.size() + CHUNK - 1) / CHUNK;
    }

    /**
     * Runs the chunks whose results have not been kept, on the {@link Workers} of the calling thread; the results do
     * not depend on their number.
     *
     * @throws java.util.concurrent.CancellationException when the thread is interrupted: complete chunks are kept
     */
    public void run(Chunks kept, Progress progress) {
        Stopping stopping = stopping();
        PrimitiveIterator.OfInt chunks = chunks().iterator();
        while (chunks.hasNext() && !stopping.isReached()) {
            int chunk = chunks.nextInt();
            Optional<List<CaseResult>> there = kept.find(chunk);
            if (there.isPresent()) {
                progress.kept(size(chunk));
                stopping.add(there.get());
            } else {
                List<CaseResult> results = results(chunk, progress);
                kept.put(chunk, results);
                stopping.add(results);
            }
        }
    }

    /**
     * Runs a chunk, on the {@link Workers} of the calling thread; the results do not depend on their number.
     *
     * @return the results, by case, then by variant
     * @throws java.util.concurrent.CancellationException when the thread is interrupted
     */
    public List<CaseResult> results(int chunk, Progress progress) {
        int first = chunk * CHUNK;
        int count = size(chunk);
        List<String> variants = cases.variants();
        CaseResult[] results = new CaseResult[count * variants.size()];
        Workers.forEach(count, i -> {
            // Only cases are distributed over threads: the loops within a case stay on its thread.
            try (Workers alone = new Workers(1)) {
                for (int v = 0; v < variants.size(); v++) {
                    String variant = variants.get(v);
                    results[i * variants.size() + v] = alone.call(() -> CaseRun.of(plan, cases, first + i, variant));
                }
            }
            progress.ran(1);
        });
        return new ArrayList<>(Arrays.asList(results));
    }
}
