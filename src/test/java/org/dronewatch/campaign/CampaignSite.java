package org.dronewatch.campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A radar on flat ground and a drone that flies in, as files beside which campaigns are written. */
public final class CampaignSite {
    /** Sixty cases of two variants, of which the first sees less far. */
    public static final String TWO_RANGES =
            """
            scene: site.yaml
            vary:
              drones.intruder.flight.bearing: {uniform: {from: -60 deg, to: 60 deg}}
              drones.intruder.flight.distance: {triangular: {from: 300 m, mode: 500 m, to: 900 m}}
              drones.intruder.speed: {values: [10 m/s, 20 m/s]}
            variants:
              near: {sensors.radar.maxRange: 350 m}
              far: {}
            runs: 60
            """;

    private static final String SITE =
            """
            world: {models: [ground.obj]}
            drones:
              intruder:
                model: packaged:quadrotor.obj
                speed: 15 m/s
                radar: {droneClass: small-uav}
                flight: {kind: inbound, target: [0, 0, 20], bearing: 0 deg, height: 40 m, distance: 600 m}
            sensors:
              radar: {use: spotterrf-c550ext, position: [0, 0, 10], aim: {azimuth: 0 deg, elevation: 0 deg}}
            alert:
              protect: {centre: [0, 0, 0], radius: 30 m}
              response: 12 s
            run: {duration: 20 s, seed: 4}
            """;

    private static final String GROUND = "v -900 0 900\nv 900 0 900\nv 900 0 -900\nv -900 0 -900\nf 1 2 3\nf 1 3 4\n";

    private CampaignSite() {}

    /** Writes the site and a campaign; returns the campaign's file. */
    public static Path in(Path directory, String campaign) throws IOException {
        Files.writeString(directory.resolve("ground.obj"), GROUND);
        Files.writeString(directory.resolve("site.yaml"), SITE);
        return Files.writeString(directory.resolve("attacks.campaign.yaml"), campaign);
    }

    /** Reads a campaign. */
    static CampaignPlan plan(Path directory, String campaign) throws IOException {
        return new CampaignPlan(CampaignReader.read(in(directory, campaign)), directory, note -> {});
    }
}
