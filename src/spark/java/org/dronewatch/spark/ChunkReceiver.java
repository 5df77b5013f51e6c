package org.dronewatch.spark;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.report.campaign.RemoteChunks;
import org.dronewatch.setting.InputException;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/** Receives the answers of the executors, as they come, on a thread of Spark's. */
final class ChunkReceiver extends AbstractFunction2<Object, ChunkAnswer, BoxedUnit> {
    private final CampaignRun run;
    private final List<Integer> chunks;
    private final BiConsumer<Integer, List<CaseResult>> target;
    private Optional<RuntimeException> failure = Optional.empty();
    private boolean isClosed;

    /**
     * A receiver.
     *
     * @param chunks the number of the chunk of each task
     * @param target receives the results of each chunk; it is called by one thread at a time
     */
    ChunkReceiver(CampaignRun run, List<Integer> chunks, BiConsumer<Integer, List<CaseResult>> target) {
        this.run = run;
        this.chunks = chunks;
        this.target = target;
    }

    @Override
    public synchronized BoxedUnit apply(Object task, ChunkAnswer answer) {
        if (!isClosed) {
            try {
                accept(chunks.get((Integer) task), answer);
            } catch (RuntimeException e) {
                isClosed = true;
                failure = Optional.of(e);
                throw e;
            }
        }
        return BoxedUnit.UNIT;
    }

    private void accept(int chunk, ChunkAnswer answer) {
        if (!answer.refusal().isEmpty()) {
            throw new InputException(answer.refusal());
        }
        target.accept(chunk, new RemoteChunks(run.plan()).read(run.cases(), chunk, answer.rows()));
    }

    /** Later answers are dropped; one that has begun to arrive is received in full. */
    synchronized void close() {
        isClosed = true;
    }

    /** What went wrong here, rather than on an executor. */
    synchronized Optional<RuntimeException> failure() {
        return failure;
    }
}
