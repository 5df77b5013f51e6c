package org.dronewatch.spark;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PrimitiveIterator;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.dronewatch.campaign.CampaignCluster;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CaseExecution;
import org.dronewatch.campaign.Stopping;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.setting.InputException;

/**
 * Runs the cases of a campaign on a Spark cluster, a chunk per task. Results are kept on the driver as they arrive; a
 * task whose executor is lost is repeated by Spark, with the same results.
 */
final class SparkCluster implements CampaignCluster {
    /** Names the campaign file as executors see it, if they share its directory with the driver. */
    static final String SHARED = "spark.dronewatch.campaign";

    /** Where the outcomes decide when a campaign ends: chunks per core that are run before they are considered. */
    private static final int AHEAD = 2;

    private JavaSparkContext context;

    private JavaSparkContext context() {
        if (context == null) {
            SparkConf settings = new SparkConf()
                    .setIfMissing("spark.app.name", "dronewatch campaign")
                    // Results do not stay in the driver's memory: there is no reason to limit their sum.
                    .setIfMissing("spark.driver.maxResultSize", "0")
                    // A line for every task would hide the progress.
                    .setIfMissing("spark.log.level", "WARN");
            if (!settings.contains("spark.master")) {
                throw new InputException("no Spark cluster: start this class with spark-submit and --master");
            }
            context = new JavaSparkContext(settings);
        }
        return context;
    }

    @Override
    public CaseExecution forCampaign(Path file) {
        return (run, kept, progress) -> run(file, run, kept, progress);
    }

    private void run(Path file, CampaignRun run, CampaignRun.Chunks kept, CampaignRun.Progress progress) {
        try (ClusterJob job = new ClusterJob(context(), file, run)) {
            if (run.endsByOutcomes()) {
                runInWaves(job, run, kept, progress);
            } else {
                runAtOnce(job, run, kept, progress);
            }
        }
    }

    private static void runAtOnce(
            ClusterJob job, CampaignRun run, CampaignRun.Chunks kept, CampaignRun.Progress progress) {
        List<Integer> missing = new ArrayList<>();
        run.chunks().forEach(chunk -> {
            if (kept.find(chunk).isPresent()) {
                progress.kept(run.size(chunk));
            } else {
                missing.add(chunk);
            }
        });
        job.run(missing, (chunk, results) -> {
            kept.put(chunk, results);
            progress.ran(run.size(chunk));
        });
    }

    /** Chunks are considered, and kept, in their order: those after the end of the campaign are not kept. */
    private void runInWaves(ClusterJob job, CampaignRun run, CampaignRun.Chunks kept, CampaignRun.Progress progress) {
        int width = AHEAD * Math.max(1, context().defaultParallelism());
        Stopping stopping = run.stopping();
        PrimitiveIterator.OfInt chunks = run.chunks().iterator();
        while (chunks.hasNext() && !stopping.isReached()) {
            List<Integer> wave = new ArrayList<>();
            while (chunks.hasNext() && wave.size() < width) {
                wave.add(chunks.nextInt());
            }
            runWave(job, run, wave, stopping, kept, progress);
        }
    }

    private static void runWave(
            ClusterJob job,
            CampaignRun run,
            List<Integer> wave,
            Stopping stopping,
            CampaignRun.Chunks kept,
            CampaignRun.Progress progress) {
        Map<Integer, List<CaseResult>> arrived = new HashMap<>();
        job.run(wave.stream().filter(chunk -> kept.find(chunk).isEmpty()).toList(), arrived::put);
        for (int chunk : wave) {
            if (stopping.isReached()) {
                return;
            }
            Optional<List<CaseResult>> there = Optional.ofNullable(arrived.get(chunk));
            if (there.isPresent()) {
                kept.put(chunk, there.get());
                progress.ran(run.size(chunk));
            } else {
                progress.kept(run.size(chunk));
            }
            stopping.add(there.or(() -> kept.find(chunk)).orElseThrow());
        }
    }

    @Override
    public void close() {
        if (context != null) {
            context.close();
        }
    }
}
