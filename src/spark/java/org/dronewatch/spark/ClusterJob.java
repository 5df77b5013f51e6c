package org.dronewatch.spark;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.BiConsumer;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import scala.reflect.ClassTag$;

/** Runs chunks of a campaign as tasks of a Spark cluster. */
final class ClusterJob implements AutoCloseable {
    private final JavaSparkContext context;
    private final CampaignRun run;
    private final ChunkOrder order;
    private final Path directory;
    private Broadcast<byte[]> archive;

    /**
     * A job.
     *
     * @param file the campaign file on the driver
     */
    ClusterJob(JavaSparkContext context, Path file, CampaignRun run) {
        this.context = context;
        this.run = run;
        this.order = ChunkOrder.of(run, file, context.getConf().get(SparkCluster.SHARED, ""));
        this.directory = Objects.requireNonNull(file.toAbsolutePath().getParent());
    }

    private Broadcast<byte[]> archive() {
        if (archive == null) {
            archive = context.broadcast(order.isShared() ? new byte[0] : SiteArchive.pack(directory));
        }
        return archive;
    }

    /**
     * Runs chunks, each as a task; returns when all are done.
     *
     * @param target receives the results of each chunk as they arrive, on other threads, one at a time
     * @throws InputException with a one-line message when the cluster, or a file on an executor, does not allow it
     * @throws CancellationException when the thread is interrupted, or the process is to end
     */
    void run(List<Integer> chunks, BiConsumer<Integer, List<CaseResult>> target) {
        if (chunks.isEmpty()) {
            return;
        }
        ChunkReceiver receiver = new ChunkReceiver(run, chunks, target);
        try {
            context.sc()
                    .runJob(
                            context.parallelize(chunks, chunks.size()).rdd(),
                            new ChunkTask(order, archive()),
                            receiver,
                            ClassTag$.MODULE$.apply(ChunkAnswer.class));
        } catch (Exception e) {
            // Scala's methods do not declare what they throw.
            receiver.close();
            if (!context.sc().isStopped()) {
                context.sc().cancelAllJobs();
            }
            throw receiver.failure().orElseGet(() -> failure(e));
        }
    }

    private RuntimeException failure(Exception problem) {
        if (problem instanceof InterruptedException) {
            Thread.currentThread().interrupt();
        }
        if (Thread.currentThread().isInterrupted() || isEnding()) {
            return new CancellationException("interrupted");
        }
        String reason = String.valueOf(problem.getMessage()).lines().findFirst().orElse("");
        return new InputException(
                "Spark: " + PlainText.line(reason) + ": the cases that were run are kept, and --resume runs the others",
                problem);
    }

    /** On Ctrl-C Spark ends, too, and may be the first to say so. */
    private static boolean isEnding() {
        Thread probe = new Thread(() -> {});
        try {
            Runtime.getRuntime().addShutdownHook(probe);
            Runtime.getRuntime().removeShutdownHook(probe);
            return false;
        } catch (IllegalStateException e) {
            return true;
        }
    }

    @Override
    public void close() {
        if (archive != null && !context.sc().isStopped()) {
            archive.destroy();
        }
    }
}
