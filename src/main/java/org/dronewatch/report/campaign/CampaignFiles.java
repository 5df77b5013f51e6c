package org.dronewatch.report.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.Sensitivity;
import org.dronewatch.campaign.SensitivityCases;
import org.dronewatch.campaign.Stopping;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import tools.jackson.databind.node.ObjectNode;

/**
 * The directory of a campaign. The results of each chunk of consecutive cases are written together once the chunk is
 * complete; only the same campaign can be resumed from these chunks. One process at a time may write into the
 * directory. For use by one thread.
 */
public final class CampaignFiles implements AutoCloseable {
    /** The directory of the chunks of the campaign's cases. */
    static final String CHUNKS = "chunks";

    /** The directory of the chunks of further cases. */
    static final String SENSITIVITY = "sensitivity";

    private static final String PLAN = CampaignPlanFile.NAME;
    private static final String LOCK = ".lock";
    private static final String UNFINISHED = ".partial-*";

    private final CampaignPlan plan;
    private final Path directory;
    private final CaseTable table;
    private final FileChannel lockFile;

    /**
     * Opens the directory, and writes the plan into a new one.
     *
     * @param resume whether the directory may hold results of the same campaign, which are then completed
     * @throws InputException when it cannot be written, is in use, or holds anything but results that may be resumed
     */
    public CampaignFiles(CampaignPlan plan, Path directory, boolean resume) {
        this.plan = plan;
        this.directory = directory.toAbsolutePath().normalize();
        this.table = new CaseTable(plan.paths());
        CampaignPlanFile file = new CampaignPlanFile(plan);
        try {
            checkFresh(file, resume);
            Files.createDirectories(this.directory);
            this.lockFile = lock();
            removeUnfinished(this.directory);
        } catch (IOException e) {
            throw new InputException(asked() + " cannot be written: " + e.getMessage(), e);
        }
        if (!Files.exists(this.directory.resolve(PLAN))) {
            begin(file);
        }
    }

    private void begin(CampaignPlanFile file) {
        try {
            writeJson(PLAN, file.toJson());
        } catch (RuntimeException e) {
            close();
            removeEmpty(directory.resolve(CHUNKS));
            removeEmpty(directory);
            throw e;
        }
    }

    private static void removeEmpty(Path where) {
        try {
            Files.deleteIfExists(where);
        } catch (IOException e) {
            // A directory that holds other files is left in place.
            return;
        }
    }

    private String asked() {
        return "--out " + PlainText.value(directory);
    }

    private void checkFresh(CampaignPlanFile file, boolean resume) throws IOException {
        Path known = directory.resolve(PLAN);
        if (Files.exists(directory) && !Files.isDirectory(directory)) {
            throw new InputException(asked() + " is a file");
        }
        if (Files.exists(known)) {
            if (!file.isSameAs(known)) {
                throw new InputException(asked() + " holds another campaign: choose another directory");
            }
            if (!resume) {
                throw new InputException(asked()
                        + " already holds this campaign: add --resume to complete it, or choose another directory");
            }
        } else if (Files.isDirectory(directory) && !isEmpty()) {
            throw new InputException(asked() + " holds other files: choose a new directory");
        }
    }

    private boolean isEmpty() throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(directory)) {
            for (Path file : files) {
                // What a process that was killed right after its start may leave behind.
                String name = String.valueOf(file.getFileName());
                if (!name.equals(LOCK)
                        && !name.equals(CHUNKS)
                        && !name.equals(SENSITIVITY)
                        && !name.startsWith(".partial-")) {
                    return false;
                }
            }
        }
        return true;
    }

    private FileChannel lock() throws IOException {
        FileChannel channel =
                FileChannel.open(directory.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        boolean isHeld = false;
        try {
            FileLock lock = channel.tryLock();
            // What is locked may have been removed in between by the run that had it.
            isHeld = lock != null && Files.exists(directory.resolve(LOCK));
        } catch (OverlappingFileLockException e) {
            throw new InputException(asked() + " is in use by another run", e);
        } finally {
            if (!isHeld) {
                channel.close();
            }
        }
        if (!isHeld) {
            throw new InputException(asked() + " is in use by another run: wait until it finishes");
        }
        return channel;
    }

    private static void removeUnfinished(Path where) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(where, UNFINISHED)) {
            for (Path file : files) {
                Files.delete(file);
            }
        }
    }

    /** The chunks of the campaign's cases. */
    public CampaignRun.Chunks chunks() {
        return chunks(plan, CHUNKS);
    }

    /** The chunks of the further cases that show which settings matter. */
    public CampaignRun.Chunks chunks(SensitivityCases cases) {
        return chunks(cases, SENSITIVITY);
    }

    private CaseChunks chunks(Cases cases, String name) {
        try {
            Path chunks = Files.createDirectories(directory.resolve(name));
            removeUnfinished(chunks);
            return new CaseChunks(cases, chunks, table);
        } catch (IOException e) {
            throw new InputException(asked() + " cannot be written: " + e.getMessage(), e);
        }
    }

    /**
     * Writes {@code runs.csv}, {@code sensitivity.csv} and {@code campaign.json} from the chunks that have been written
     * and, if none is missing, {@code report.html}.
     *
     * @param caseCommand the command that runs a case again, without {@code --case} and its number; empty if there is
     *     none
     * @return the results of the campaign so far
     */
    public CampaignResult finish(Optional<String> caseCommand) {
        WorstCases worst = new WorstCases();
        CampaignSummary summary = new CampaignSummary(plan.variants());
        Stopping stopping = new Stopping(plan);
        int variants = plan.variants().size();
        copyAll("runs.csv", plan, chunks(), stopping, results -> {
            for (int i = 0; i < results.size(); i += variants) {
                summary.add(results.subList(i, i + variants));
            }
            worst.add(results);
        });
        Optional<Sensitivity> sensitivity =
                plan.sensitivity().map(this::sensitivity).filter(Sensitivity::isComplete);
        CampaignResult result = new CampaignResult(summary, stopping, sensitivity);
        CampaignFile file = new CampaignFile(plan, result);
        writeJson("campaign.json", file.toJson());
        if (file.isComplete()) {
            new WholeFile("--out", directory.resolve(CampaignReport.NAME).toString())
                    .write(new CampaignReport(plan, result, worst, caseCommand)::write);
        }
        return result;
    }

    private Sensitivity sensitivity(SensitivityCases cases) {
        Sensitivity sensitivity = new Sensitivity(cases);
        copyAll("sensitivity.csv", cases, chunks(cases), new Stopping(cases), sensitivity::add);
        return sensitivity;
    }

    /** Copies the cases that have been run into a table, up to the one with which the campaign ends. */
    private void copyAll(
            String name, Cases cases, CampaignRun.Chunks chunks, Stopping stopping, Consumer<List<CaseResult>> also) {
        int count = CampaignRun.chunks(cases);
        new WholeFile("--out", directory.resolve(name).toString()).write(stream -> {
            table.write(stream, List.of());
            for (int number = 0; number < count && !stopping.isReached(); number++) {
                List<CaseResult> there = chunks.find(number).orElse(List.of());
                int variants = cases.variants().size();
                List<CaseResult> results = there.subList(0, stopping.add(there) * variants);
                also.accept(results);
                table.writeRows(stream, results);
            }
        });
    }

    /**
     * Writes a file that states where the results come from.
     *
     * @param provenance the contents of the file
     */
    public void writeProvenance(ObjectNode provenance) {
        writeJson(ProvenanceFile.NAME, provenance);
    }

    /** Writes the results in JUnit's XML format. */
    public void writeJunit(CampaignResult result, OutputStream stream) throws IOException {
        new JunitFile(plan, result.summary(), chunks()).write(stream);
    }

    private void writeJson(String name, ObjectNode content) {
        new WholeFile("--out", directory.resolve(name).toString())
                .writeFile(partial -> JsonFile.write(partial, content));
    }

    /** Releases the directory, so that other processes may write into it. */
    @Override
    public void close() {
        try {
            Files.deleteIfExists(directory.resolve(LOCK));
            lockFile.close();
        } catch (IOException e) {
            // The lock ends with the process.
            return;
        }
    }
}
