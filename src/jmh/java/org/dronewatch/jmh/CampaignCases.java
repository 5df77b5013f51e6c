package org.dronewatch.jmh;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.CaseRun;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.variation.Uniform;
import org.dronewatch.campaign.variation.Variation;
import org.dronewatch.parallel.Workers;
import org.dronewatch.setting.SettingsPath;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** Time of a case of a campaign: 60 s of multi-sensor with twelve cameras at 5 looks per second, no microphone. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 3)
@Measurement(iterations = 5, time = 3)
public class CampaignCases {
    private static final int CASES = 1000;
    private static final List<String> CORNERS = List.of("north-east", "south-east", "south-west", "north-west");

    /** The number of cases that are run at the same time. */
    @Param({"1", "2"})
    public int threads;

    private Workers workers;
    private CampaignPlan plan;
    private int next;

    /** Loads the scene, and runs all cases once, so that the views of the cameras are known. */
    @Setup(Level.Trial)
    public void load() {
        workers = new Workers(threads);
        Map<String, String> changes = new LinkedHashMap<>();
        changes.put("run.duration", "60 s");
        changes.put("drones.quadrotor.flight.distance", "315 m");
        changes.put("sensors.microphone.enabled", "false");
        CORNERS.stream()
                .flatMap(corner -> Stream.of("1", "2", "3").map(number -> corner + "-" + number))
                .forEach(camera -> changes.put("sensors." + camera + ".rate", "5 Hz"));
        Map<String, Variation> vary = Map.of(
                "drones.quadrotor.flight.bearing", between("0 deg", "360 deg"),
                "drones.quadrotor.flight.height", between("-10 m", "40 m"));
        plan = workers.call(() -> new CampaignPlan(
                new SettingsPath("runs")
                        .write(
                                CampaignSettings.of("multi-sensor")
                                        .withVary(vary)
                                        .withVariants(Map.of("cameras", changes)),
                                Integer.toString(CASES)),
                Path.of("").toAbsolutePath(),
                note -> {}));
        workers.call(() -> {
            Workers.forEach(CASES, number -> CaseRun.of(plan, number, "cameras"));
            return null;
        });
    }

    private static Variation between(String from, String to) {
        return Variation.of(new Uniform(from, to));
    }

    /** Stops the threads. */
    @TearDown
    public void close() {
        workers.close();
    }

    /** The time per case of whole chunks. */
    @Benchmark
    @OperationsPerInvocation(CampaignRun.CHUNK)
    public int chunk() {
        next = (next + 1) % (CASES / CampaignRun.CHUNK);
        One one = new One(next);
        workers.call(() -> {
            new CampaignRun(plan).run(one, cases -> {});
            return null;
        });
        return one.results;
    }

    /** Lets a single chunk run. */
    private static final class One implements CampaignRun.Chunks {
        private final int missing;
        private int results;

        One(int missing) {
            this.missing = missing;
        }

        @Override
        public Optional<List<CaseResult>> find(int chunk) {
            return chunk == missing ? Optional.empty() : Optional.of(List.of());
        }

        @Override
        public void put(int chunk, List<CaseResult> made) {
            results += made.size();
        }
    }
}
