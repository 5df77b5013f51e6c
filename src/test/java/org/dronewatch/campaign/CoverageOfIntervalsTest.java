package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.LongForm;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Many campaigns of a scene whose probability of detection is known in closed form: a drone of Swerling's first case
 * that hovers before a radar, for three independent looks.
 */
class CoverageOfIntervalsTest {
    private static final int CAMPAIGNS = LongForm.count(80, 200);
    private static final long FIRST_SEED = 7_000;
    private static final int CASES = 24;
    private static final int LOOKS = 3;
    private static final double RANGE = 200.0;
    private static final double CROSS_SECTION = 2e-4;
    private static final double FALSE_ALARM = 1e-6;
    private static final double CONFIDENCE = 0.95;

    /** Looks at 0, 1 and 2 s. */
    private static final String SITE =
            """
            world: {models: [floor.obj]}
            drones:
              intruder:
                model: drone.obj
                radar: {crossSection: %s, fluctuation: swerling-1}
                flight: {kind: hover, position: [0, %s, 30]}
            sensors:
              radar:
                kind: radar
                position: [0, 0, 30]
                aim: {azimuth: 0 deg, elevation: 0 deg}
                frequency: 10 GHz
                rate: 1 Hz
                minSpeed: 0 m/s
                budget:
                  kind: hardware
                  power: 1 W
                  gain: 20 dB
                  integrationTime: 1 ms
                  noiseFigure: 5 dB
                  losses: 6 dB
                detection: {kind: chance, falseAlarm: %s}
            run: {duration: 2.5 s}
            """
                    .formatted(CROSS_SECTION, RANGE, FALSE_ALARM);

    @TempDir
    private Path directory;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(directory.resolve("floor.obj"), "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf 1 2 3\nf 1 3 4\n");
        Files.writeString(
                directory.resolve("drone.obj"),
                "v -1 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 2 4 3\nf 1 4 2\n");
        Files.writeString(directory.resolve("hovering.yaml"), SITE);
    }

    /**
     * The radar equation with T0 = 290 K and the noise bandwidth 1 / (1 ms) (Skolnik, Radar Handbook); then
     * {@code Pd = Pfa^(1 / (1 + SNR))}, Swerling 1960 for one pulse.
     */
    private static double detected() {
        double wavelength = 299_792_458.0 / 10e9;
        double received = wavelength * wavelength * CROSS_SECTION / (Math.pow(4.0 * Math.PI, 3) * Math.pow(RANGE, 4));
        double noise = 1.380649e-23 * 290.0 * 1000.0;
        double ratio = received / noise * Math.pow(10.0, 0.1 * (20.0 + 20.0 - 5.0 - 6.0));
        double look = Math.pow(FALSE_ALARM, 1.0 / (1.0 + ratio));
        return 1.0 - Math.pow(1.0 - look, LOOKS);
    }

    /** How many of the cases of a campaign detect the drone. */
    private int count(CampaignSettings settings, long seed) {
        CampaignPlan plan =
                new CampaignPlan(new SettingsPath("seed").write(settings, Long.toString(seed)), directory, note -> {});
        CampaignSummary summary = new CampaignSummary(plan.variants());
        for (int number = 0; number < plan.runs(); number++) {
            summary.add(List.of(CaseRun.of(plan, number, CampaignSettings.ALONE)));
        }
        Proportion proportion = summary.variants()
                .get(CampaignSettings.ALONE)
                .proportion(Outcome.DETECTED)
                .orElseThrow();
        assertThat(proportion.of()).isEqualTo(CASES);
        return proportion.count();
    }

    /** Of all cases together, the share is within three standard deviations. */
    @Test
    void intervalsOfManyCampaignsContainTheProbabilityOfTheClosedForm() {
        double p = detected();
        assertThat(coverage(p)).as("counts are whole numbers").isBetween(0.945, 0.955);
        CampaignSettings settings =
                new SettingsPath("runs").write(CampaignSettings.of("hovering.yaml"), Integer.toString(CASES));
        int held = 0;
        int detected = 0;
        for (int campaign = 0; campaign < CAMPAIGNS; campaign++) {
            int count = count(settings, FIRST_SEED + campaign);
            detected += count;
            held += new Proportion(count, CASES).wilson(CONFIDENCE).contains(p) ? 1 : 0;
        }
        System.out.printf("seeds from %d: %d of %d intervals contain %.4f%n", FIRST_SEED, held, CAMPAIGNS, p);
        assertThat((double) held / CAMPAIGNS).isBetween(0.90, 0.99);
        int all = CAMPAIGNS * CASES;
        assertThat((double) detected / all).isCloseTo(p, within(3.0 * Math.sqrt(p * (1.0 - p) / all)));
    }

    /** Exactly: the probabilities of all counts whose interval contains p. */
    private static double coverage(double p) {
        double held = 0.0;
        double chance = Math.pow(1.0 - p, CASES);
        for (int k = 0; k <= CASES; k++) {
            held += new Proportion(k, CASES).wilson(CONFIDENCE).contains(p) ? chance : 0.0;
            chance *= (CASES - k) / (k + 1.0) * p / (1.0 - p);
        }
        return held;
    }
}
