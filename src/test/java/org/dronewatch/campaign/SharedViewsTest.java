package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.campaign.outcome.CaseResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What cameras see of the site without drones is traced once for all cases and variants. */
class SharedViewsTest {
    private static final String SITE =
            """
            world: {models: [ground.obj]}
            drones:
              intruder:
                model: packaged:quadrotor.obj
                speed: 15 m/s
                flight: {kind: inbound, target: [0, 0, 2], bearing: 0 deg, height: 10 m, distance: 80 m}
            sensors:
              north: {kind: camera, position: [0, 0, 3], aim: {azimuth: 0 deg, elevation: 0 deg}, rate: 5 Hz}
              east: {kind: camera, position: [0, 0, 3], aim: {azimuth: 40 deg, elevation: 0 deg}, rate: 5 Hz}
            run: {duration: 4 s, seed: 4}
            """;

    private static final String CAMPAIGN =
            """
            scene: cameras.yaml
            vary:
              drones.intruder.flight.bearing: {uniform: {from: -30 deg, to: 60 deg}}
            variants:
              dry: {}
              rain: {world.rain: 5 mm/h}
              wide: {sensors.east.fov: 1.2 rad}
            runs: 12
            """;

    @TempDir
    private Path directory;

    @BeforeEach
    void write() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        Files.writeString(directory.resolve("cameras.yaml"), SITE);
    }

    private static List<CaseResult> all(CampaignPlan plan) {
        List<CaseResult> results = new ArrayList<>();
        for (int number = 0; number < plan.runs(); number++) {
            for (String variant : plan.variants()) {
                results.add(CaseRun.of(plan, number, variant));
            }
        }
        return results;
    }

    @Test
    void aViewIsMadeForEachPoseOfACameraAndEveryTileOfItOnce() throws IOException {
        CampaignPlan plan = CampaignSite.plan(directory, CAMPAIGN);
        List<CaseResult> first = all(plan);

        assertThat(first).noneMatch(CaseResult::isFailed).anyMatch(one -> one.firstDetected()
                .isPresent());
        assertThat(plan.memory().made()).as("two cameras, and the wide one").isEqualTo(3);
        long bytes = plan.memory().bytes();
        assertThat(bytes).isPositive();
        assertThat(all(plan)).isEqualTo(first);
        assertThat(plan.memory().made()).isEqualTo(3);
        assertThat(plan.memory().bytes()).as("nothing is traced again").isEqualTo(bytes);
    }

    @Test
    void theResultsAreThoseOfCasesThatShareNothing() throws IOException {
        CampaignPlan shared = CampaignSite.plan(directory, CAMPAIGN);
        List<CaseResult> alone = new ArrayList<>();
        for (int number = 0; number < shared.runs(); number++) {
            CampaignPlan own = CampaignSite.plan(directory, CAMPAIGN);
            for (String variant : own.variants()) {
                alone.add(CaseRun.of(own, number, variant));
            }
        }

        assertThat(all(shared)).isEqualTo(alone);
    }

    @Test
    void aSettingOfTheCameraThatVariesGivesEachCaseItsOwnView() throws IOException {
        CampaignPlan plan = CampaignSite.plan(
                directory,
                """
                scene: cameras.yaml
                vary:
                  sensors.east.fov: {uniform: {from: 0.5 rad, to: 1.2 rad}}
                runs: 5
                """);

        assertThat(all(plan)).noneMatch(CaseResult::isFailed);
        assertThat(plan.memory().made()).as("the one at rest, and five").isEqualTo(6);
    }
}
