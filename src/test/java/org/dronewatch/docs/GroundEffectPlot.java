package org.dronewatch.docs;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Ground;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sensor.acoustic.energy.EnergyTracer;
import org.dronewatch.sensor.acoustic.energy.SoundSource;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.Wind;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.Styler.LegendPosition;

/**
 * The levels of a small quadrotor 5 m above hard ground, and above grass with and without wind, beside the free field.
 */
final class GroundEffectPlot {
    private static final double NEAREST = 10.0;
    private static final double FARTHEST = 1000.0;
    private static final int POINTS = 241;
    private static final double HALF = 3000.0;
    private static final Position MICROPHONE = new Position(0, 0, 1.5);
    private static final double DRONE_HEIGHT = 5.0;
    private static final double WIND = 5.0;

    /** What is plotted. */
    private enum Quantity {
        A_WEIGHTED("A-weighted", EnergyReading::aWeightedLevel),
        AT_500_HZ("500 Hz band", reading -> reading.level(3));

        private final String title;
        private final ToDoubleFunction<EnergyReading> level;

        Quantity(String title, ToDoubleFunction<EnergyReading> level) {
            this.title = "Drone at 5 m, microphone at 1.5 m: " + title;
            this.level = level;
        }

        private double[] of(List<EnergyReading> readings) {
            return readings.stream().mapToDouble(level).toArray();
        }
    }

    private GroundEffectPlot() {}

    static BufferedImage draw() {
        double[] distances = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            distances[i] = NEAREST * Math.pow(FARTHEST / NEAREST, i / (POINTS - 1.0));
        }
        List<EnergyReading> hardGround = over(plain("asphalt"), distances);
        List<EnergyReading> grass = over(plain("grass_turf"), distances);
        // The drone is east of the microphone.
        List<EnergyReading> downwind = over(plain("grass_turf", new Wind(WIND, Math.toRadians(90), 0.03)), distances);
        List<EnergyReading> upwind = over(plain("grass_turf", new Wind(WIND, Math.toRadians(270), 0.03)), distances);
        List<EnergyReading> free = free(distances);
        XYChart[] charts = Stream.of(Quantity.values())
                .map(quantity -> {
                    XYChart chart = chart(quantity.title);
                    DocChart.add(chart, "grass, downwind", distances, quantity.of(downwind), new Color(0x8fbf3f));
                    DocChart.add(chart, "grass, upwind", distances, quantity.of(upwind), new Color(0xc2410c));
                    DocChart.add(chart, "grass", distances, quantity.of(grass), new Color(0x2a9d5c));
                    DocChart.add(chart, "asphalt", distances, quantity.of(hardGround), new Color(0x1f5fbf));
                    DocChart.add(chart, "free field", distances, quantity.of(free), Color.GRAY);
                    return chart;
                })
                .toArray(XYChart[]::new);
        return DocChart.beside(charts[0], charts[1]);
    }

    private static XYChart chart(String title) {
        XYChart chart = DocChart.of(DocChart.HALF_WIDTH, title, "horizontal distance [m]", "sound pressure level [dB]");
        chart.getStyler()
                .setXAxisLogarithmic(true)
                .setYAxisMin(0.0)
                .setYAxisMax(60.0)
                .setLegendPosition(LegendPosition.InsideNE);
        return chart;
    }

    private static List<EnergyReading> over(World world, double[] distances) {
        EnergyTracer tracer = new EnergyTracer(EnergyModel.DEFAULT.withGround(Ground.COHERENT), MICROPHONE, 0.5, world);
        return DoubleStream.of(distances)
                .mapToObj(distance -> tracer.trace(drone(distance), new SplittableRandom(1), RayRecorder.NONE))
                .toList();
    }

    private static List<EnergyReading> free(double[] distances) {
        EnergyTracer tracer = new EnergyTracer(EnergyModel.DEFAULT, MICROPHONE, 0.5, plain("asphalt"));
        return DoubleStream.of(distances)
                .mapToObj(distance -> tracer.inTheOpen(drone(distance)))
                .toList();
    }

    private static SoundSource drone(double distance) {
        DroneSound sound = DroneSounds.get(DroneSounds.SMALL_QUADROTOR);
        return new SoundSource(
                new Position(distance, 0, DRONE_HEIGHT),
                DroneSound.octaves(sound.shape(), sound.level()),
                Directivity.OMNIDIRECTIONAL);
    }

    private static World plain(String material) {
        return plain(material, Wind.CALM);
    }

    private static World plain(String material, Wind wind) {
        float half = (float) HALF;
        TriangleMesh square = TriangleMesh.of(
                new float[] {-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0},
                new int[] {0, 1, 2, 0, 2, 3});
        return new World(
                KDTree.of(square),
                BackgroundNoise.of(20),
                List.of(SurfaceMaterials.get(material)),
                Atmosphere.STANDARD.withWind(wind));
    }
}
