package org.dronewatch.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.apache.spark.SparkFiles;
import org.apache.spark.broadcast.Broadcast;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignReader;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignScenes;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.report.campaign.RemoteChunks;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** The campaign of an executor: read once, with its trees and views, for all tasks in this JVM. Thread-safe. */
final class ExecutorCampaign {
    private static ExecutorCampaign held;

    private final CampaignPlan plan;
    private final String hash;
    private final Path directory;
    private final String told;

    private ExecutorCampaign(CampaignPlan plan, Path directory, String told) {
        this.plan = plan;
        this.hash = new RemoteChunks(plan).hash();
        this.directory = directory;
        this.told = told;
    }

    /**
     * The campaign of an order.
     *
     * @throws InputException when it cannot be read, or is not the one that the driver has read
     */
    static ExecutorCampaign of(ChunkOrder order, Broadcast<byte[]> archive) {
        synchronized (ExecutorCampaign.class) {
            if (held == null || !held.hash.equals(order.hash())) {
                held = read(order, archive);
            }
            return held;
        }
    }

    private static ExecutorCampaign read(ChunkOrder order, Broadcast<byte[]> archive) {
        Path file = order.isShared() ? Path.of(order.file()) : unpacked(archive).resolve(order.file());
        Path directory =
                Objects.requireNonNull(file.toAbsolutePath().normalize().getParent());
        CampaignScenes beside = CampaignScenes.beside(directory);
        CampaignScenes scenes = order.isStored() ? beside : beside.withStore(StorePlace.NONE);
        CampaignPlan plan = new CampaignPlan(order.applyTo(CampaignReader.read(file)), directory, scenes, note -> {});
        ExecutorCampaign campaign = new ExecutorCampaign(plan, directory, order.directory());
        if (!campaign.hash.equals(order.hash())) {
            throw new InputException(PlainText.value(file) + ": the campaign, its scene, a model or the version of"
                    + " dronewatch differs on an executor from what the driver has read");
        }
        return campaign;
    }

    /** Spark deletes the directory with the executor's others. */
    private static Path unpacked(Broadcast<byte[]> archive) {
        try {
            Path root = Path.of(SparkFiles.getRootDirectory()).toAbsolutePath().normalize();
            Path target = Files.createTempDirectory(root, "site-");
            SiteArchive.unpack(archive.value(), target);
            return target;
        } catch (IOException e) {
            throw new InputException("the site cannot be unpacked on an executor: " + e.getMessage(), e);
        }
    }

    /** Runs a chunk on the calling thread; gives the bytes of its file. */
    byte[] rows(boolean isSensitivity, int chunk) {
        Cases cases = isSensitivity ? plan.sensitivity().orElseThrow() : plan;
        List<CaseResult> results = new CampaignRun(plan, cases).results(chunk, ran -> {});
        return new RemoteChunks(plan)
                .write(results.stream().map(this::asOnTheDriver).toList());
    }

    /** The same bytes everywhere: messages name the files where the driver has them. */
    private CaseResult asOnTheDriver(CaseResult result) {
        Optional<String> error = result.error().map(text -> text.replace(directory.toString(), told));
        return error.equals(result.error()) ? result : result.withError(error);
    }
}
