package org.dronewatch.spark;

import java.io.Serializable;
import org.apache.spark.TaskContext;
import org.apache.spark.broadcast.Broadcast;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction2;

/**
 * Runs a chunk on an executor. What is wrong with the input is an answer: it would be as wrong a second time. Any other
 * failure ends the task, which Spark then repeats elsewhere.
 */
final class ChunkTask extends AbstractFunction2<TaskContext, Iterator<Integer>, ChunkAnswer> implements Serializable {
    private static final long serialVersionUID = 1L;

    private final ChunkOrder order;
    private final Broadcast<byte[]> archive;

    /**
     * A task.
     *
     * @param archive the files; empty if they are shared
     */
    ChunkTask(ChunkOrder order, Broadcast<byte[]> archive) {
        this.order = order;
        this.archive = archive;
    }

    @Override
    public ChunkAnswer apply(TaskContext context, Iterator<Integer> chunks) {
        int chunk = chunks.next();
        try {
            ExecutorCampaign campaign = ExecutorCampaign.of(order, archive);
            return ChunkAnswer.of(campaign.rows(order.isSensitivity(), chunk));
        } catch (InputException e) {
            return ChunkAnswer.refused(PlainText.line(e.getMessage()));
        }
    }
}
