package org.dronewatch.docs;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.radar.BeamPattern;
import org.dronewatch.sensor.radar.Clutter;
import org.dronewatch.sensor.radar.DopplerFilter.HighPass;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarSensor;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.radar.SurfaceReflectivity.LandCover;
import org.dronewatch.world.World;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.Styler.LegendPosition;

/**
 * The echo of a drone that flies straight past a radar over level farmland, and what a notch and clutter leave of it.
 */
final class CrossingPlot {
    private static final double REACH = 600.0;
    private static final int POINTS = 801;
    private static final double CLOSEST = 200.0;
    private static final double SPEED = 5.0;
    private static final double LEAST = 0.0;
    private static final float HALF = 3000F;

    private CrossingPlot() {}

    static BufferedImage draw() {
        RadarSettings bare = RadarSettings.at(new Position(0, 0, 10), Hardware.of(0.05, 25.0, 0.02))
                .withSpeeds(0.0, 100.0)
                .withBeam(BeamPattern.of(Math.toRadians(4), Math.toRadians(10)).withScanLoss(0.0));
        RadarSettings notched = bare.withNotch(HighPass.of(2.0));
        RadarSettings cluttered = notched.withClutter(Clutter.of(new LandCover(LandCover.Cover.FARMLAND), 30.0));
        RadarSignature body = RadarSignature.DEFAULT.withCrossSection(0.05);
        RadarSignature rotors = body.withRotorLevel(20.0);
        XYChart chart = chart();
        add(chart, "neither notch nor clutter", bare, body, Color.GRAY);
        add(chart, "notch, 2 m/s", notched, body, new Color(0x1f5fbf));
        add(chart, "and rotors 20 dB below the body", notched, rotors, new Color(0x2a9d5c));
        add(chart, "and farmland clutter, suppressed by 30 dB", cluttered, rotors, new Color(0xc2410c));
        DocChart.add(chart, "threshold", new double[] {-REACH, REACH}, new double[] {15.0, 15.0}, Color.BLACK, 1F);
        return BitmapEncoder.getBufferedImage(chart);
    }

    private static XYChart chart() {
        XYChart chart = DocChart.of(
                960,
                "A pass at a distance of 200 m and a speed of 5 m/s, 20 m above level ground",
                "position along the path [m]",
                "signal over noise and clutter [dB]");
        chart.getStyler().setYAxisMin(LEAST).setYAxisMax(50.0).setLegendPosition(LegendPosition.OutsideS);
        return chart;
    }

    private static void add(
            XYChart chart, String name, RadarSettings settings, RadarSignature signature, Color colour) {
        RadarSensor radar = settings.create();
        World ground = level();
        Drone drone = drone(signature);
        double[] x = new double[POINTS];
        double[] ratio = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            // Denser about the closest point.
            double along = 2.0 * i / (POINTS - 1) - 1.0;
            x[i] = REACH * along * Math.abs(along);
            FlightState state =
                    new FlightState(new Position(x[i], CLOSEST, 20.0), new Position(SPEED, 0, 0), 0.5 * Math.PI);
            double seen = radar.observe(ground, List.of(drone.at(state)), Look.of(1L, "radar", i, i))
                    .get(0)
                    .value();
            ratio[i] = Math.max(LEAST, seen);
        }
        DocChart.add(chart, name, x, Arrays.copyOf(ratio, POINTS), colour);
    }

    private static Drone drone(RadarSignature signature) {
        Position start = new Position(0, CLOSEST, 20.0);
        DroneSettings settings = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(start))
                .withRadar(signature);
        // A box of the quadrotor's size: only its bounds matter.
        float[] corners = {-0.3F, -0.2F, -0.15F, 0.3F, 0.2F, 0.15F, 0.3F, -0.2F, -0.15F};
        return new Drone("drone", settings, KDTree.of(TriangleMesh.of(corners, new int[] {0, 1, 2})));
    }

    private static World level() {
        return World.of(TriangleMesh.of(
                new float[] {-HALF, -HALF, 0, HALF, -HALF, 0, HALF, HALF, 0, -HALF, HALF, 0},
                new int[] {0, 1, 2, 0, 2, 3}));
    }
}
