package org.dronewatch.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.report.campaign.CampaignFile;
import org.dronewatch.report.campaign.CampaignFiles;
import org.dronewatch.report.campaign.CampaignPart;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.RecordedCommand;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Joins the parts of a campaign that were run separately. */
@Command(
        name = "merge",
        mixinStandardHelpOptions = true,
        description = {
            "Joins the parts of a campaign that were run with --shard into the results of the whole campaign,"
                    + " byte-identical to those of a single run.",
            "The campaign file is read again, from the path that was given when the first part was run."
        },
        footer = {"", "Example:", "  dronewatch merge part-1 part-2 part-3 part-4 --out vendors"})
final class MergeCommand implements Callable<Integer> {
    private static final int MOST_NAMED = 5;

    @Parameters(arity = "1..*", paramLabel = "DIR", description = "The results of each part.")
    private List<String> parts = new ArrayList<>();

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "New directory for the results.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        Path first = PathWord.of("", parts.get(0)).resolve(ProvenanceFile.NAME);
        Replay part = new Replay(first, RecordedCommand.read(first));
        return threads.call(() -> merge(part, part.campaign().plan(StoreSwitch.of(spec), Notes.of(spec))));
    }

    private int merge(Replay part, CampaignPlan plan) {
        List<CampaignPart> there = parts.stream()
                .map(name -> new CampaignPart(plan, PathWord.of("", name)))
                .toList();
        checkWhole("", plan, there);
        plan.sensitivity().ifPresent(further -> checkWhole(" of the sensitivity analysis", further, there));
        Path directory = PathWord.of("--out", out);
        int code;
        try (CampaignFiles files = new CampaignFiles(plan, directory, false)) {
            files.writeProvenance(part.campaign().provenance(plan, part.wordsOfAll(directory)));
            copy(plan, there, files.chunks());
            plan.sensitivity().ifPresent(further -> copy(further, there, files.chunks(further)));
            CampaignResult result = files.finish(Optional.of(part.campaign().caseCommand()));
            json.print(new CampaignFile(plan, result)::toJson, target -> CampaignLines.print(plan, result, target));
            PrintWriter err = spec.commandLine().getErr();
            int failure = CampaignLines.warn(result.summary(), err);
            code = Math.max(failure, CampaignLines.judge(plan, result.summary(), err));
        }
        Notes.of(spec).accept("results in " + directory);
        return code;
    }

    private static void copy(Cases cases, List<CampaignPart> there, CampaignRun.Chunks target) {
        for (int chunk = 0; chunk < CampaignRun.chunks(cases); chunk++) {
            target.put(chunk, find(cases, there, chunk).orElseThrow());
        }
    }

    private static Optional<List<CaseResult>> find(Cases cases, List<CampaignPart> there, int chunk) {
        return there.stream()
                .map(part -> part.find(cases, chunk))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private static void checkWhole(String analysis, Cases cases, List<CampaignPart> there) {
        List<String> missing = new ArrayList<>();
        int count = 0;
        int first = -1;
        int chunks = CampaignRun.chunks(cases);
        for (int chunk = 0; chunk <= chunks; chunk++) {
            boolean isMissing = chunk < chunks && find(cases, there, chunk).isEmpty();
            if (isMissing && first < 0) {
                first = chunk * CampaignRun.CHUNK;
            } else if (!isMissing && first >= 0) {
                int last = Math.min(chunk * CampaignRun.CHUNK, cases.size()) - 1;
                missing.add(first == last ? Integer.toString(first) : first + " to " + last);
                count += last - first + 1;
                first = -1;
            }
        }
        if (!missing.isEmpty()) {
            String more = missing.size() > MOST_NAMED ? " and others" : "";
            throw new InputException("no directory has " + (count == 1 ? "case " : "cases ")
                    + String.join(", ", missing.subList(0, Math.min(MOST_NAMED, missing.size()))) + more + analysis);
        }
    }
}
