package org.dronewatch.report.campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.report.file.WholeFile;

/** Chunks of cases, each in a separate file of one directory. */
final class CaseChunks implements CampaignRun.Chunks {
    private final Cases cases;
    private final Path directory;
    private final CaseTable table;

    CaseChunks(Cases cases, Path directory, CaseTable table) {
        this.cases = cases;
        this.directory = directory;
        this.table = table;
    }

    private Path file(int number) {
        return directory.resolve(String.format(Locale.ROOT, "%06d.csv", number));
    }

    /** {@inheritDoc} A damaged file does not count as a chunk: its cases are run again. */
    @Override
    public Optional<List<CaseResult>> find(int number) {
        if (!Files.isRegularFile(file(number))) {
            return Optional.empty();
        }
        try {
            List<CaseResult> results = table.read(file(number));
            return isWhole(cases, number, results) ? Optional.of(results) : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Whether these are the results of a chunk, all of them and no others. */
    static boolean isWhole(Cases cases, int number, List<CaseResult> results) {
        int first = number * CampaignRun.CHUNK;
        int count = Math.min(CampaignRun.CHUNK, cases.size() - first);
        List<String> variants = cases.variants();
        if (results.size() != count * variants.size()) {
            return false;
        }
        for (int i = 0; i < results.size(); i++) {
            CaseResult result = results.get(i);
            int one = first + i / variants.size();
            if (result.number() != one
                    || !result.variant().equals(variants.get(i % variants.size()))
                    || result.seed() != cases.seed(one)
                    || !result.values().equals(cases.values(one))) {
                return false;
            }
        }
        return true;
    }

    @Override
    public void put(int number, List<CaseResult> results) {
        new WholeFile("--out", file(number).toString()).write(stream -> table.write(stream, results));
    }
}
