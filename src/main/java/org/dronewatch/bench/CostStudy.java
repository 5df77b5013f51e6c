package org.dronewatch.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.world.World;

/** Measures costs as functions of the number of triangles, rays, sensors, drones and threads, on generated ground. */
public final class CostStudy {
    private static final int SITE_TRIANGLES = 65_000;
    private static final int MOST = 64;
    private static final double DRONE_DISTANCE = 60.0;

    /** The tree over the drone's model, which all drones share, as in a scene. */
    private final KDTree droneTree;

    private final int largest;
    private final Consumer<String> progress;
    private final Stopwatch watch;

    /**
     * A study.
     *
     * @param droneMesh the drone's model in its own frame
     * @param largest number of triangles of the largest terrain
     * @param progress receives the name of the next measurement
     */
    public CostStudy(TriangleMesh droneMesh, int largest, Consumer<String> progress) {
        this(droneMesh, largest, new Stopwatch(), progress);
    }

    CostStudy(TriangleMesh droneMesh, int largest, Stopwatch watch, Consumer<String> progress) {
        this.droneTree = KDTree.of(droneMesh);
        this.largest = largest;
        this.watch = watch;
        this.progress = progress;
    }

    /** Runs the study. */
    public List<CostCurves> run() {
        List<CostCurves> all = new ArrayList<>(new TracingStudy(largest, watch, progress).run());
        World site = World.of(RollingTerrain.of(SITE_TRIANGLES));
        all.add(overRays(site));
        all.add(overSensors(site));
        all.add(overDrones(site));
        all.add(overThreads(site));
        return all;
    }

    private CostCurves overRays(World site) {
        CostCurves.Points level = new CostCurves.Points("level model");
        CostCurves.Points energy = new CostCurves.Points("energy model");
        Drone drone = droneAt(new Position(0, DRONE_DISTANCE, 0), site);
        Position position = above(site, 0, 0, 2.0);
        for (int rays = 250; rays <= 64_000; rays *= 4) {
            int count = rays;
            progress.accept(String.format(Locale.ROOT, "%,d sound rays", rays));
            AcousticSensor byLevel = AcousticSettings.at(position)
                    .withPropagation(LevelModel.DEFAULT
                            .withAttenuation(0.0)
                            .withRays(count, 1)
                            .withLimits(3, 100 * count))
                    .create();
            level.add(
                    rays,
                    1e3
                            * watch.seconds(
                                    () -> byLevel.listenFully(site, drone, new SplittableRandom(1), RayRecorder.NONE)));
            AcousticSensor byEnergy = AcousticSettings.at(position)
                    .withPropagation(EnergyModel.DEFAULT.withRays(count).withAccuracy(0.0))
                    .create();
            energy.add(rays, 1e3 * watch.seconds(() -> byEnergy.read(site, drone, new SplittableRandom(1))));
        }
        return new CostCurves(
                "rays",
                "One look of a microphone on " + Counted.of(Workers.available(), "thread"),
                "rays sent out",
                "time [ms]",
                List.of(level.line(), energy.line()));
    }

    private CostCurves overSensors(World site) {
        Drone drone = droneAt(new Position(0, 0, 0), site);
        CostCurves.Points look = new CostCurves.Points("cameras that see the drone");
        CostCurves.Points away = new CostCurves.Points("cameras that look elsewhere");
        CostCurves.Points ears = new CostCurves.Points("microphones, level model");
        for (int count = 1; count <= MOST; count *= 2) {
            progress.accept(Counted.of(count, "sensor"));
            look.add(count, frame(site, List.of(drone), cameras(site, count, false)));
            away.add(count, frame(site, List.of(drone), cameras(site, count, true)));
            ears.add(count, frame(site, List.of(drone), microphones(site, count)));
        }
        return new CostCurves(
                "sensors",
                "One look of full HD cameras or microphones on " + Counted.of(Workers.available(), "thread")
                        + ", drone at 60 m",
                "sensors",
                "time [us]",
                List.of(look.line(), away.line(), ears.line()));
    }

    private CostCurves overDrones(World site) {
        CostCurves.Points look = new CostCurves.Points("one camera, full HD");
        for (int count = 1; count <= MOST; count *= 2) {
            progress.accept(Counted.of(count, "drone"));
            List<Drone> drones = of(count, i -> droneAt(inRows(i), site));
            Sensor camera = CameraSettings.at(above(site, 0, -0.75 * DRONE_DISTANCE, 20.0))
                    .withLookAt(above(site, 0, DRONE_DISTANCE / 4, 20.0))
                    .create();
            look.add(count, frame(site, drones, List.of(camera)));
        }
        return new CostCurves(
                "drones", "One frame of a camera, drones at 60 m", "drones", "time [us]", List.of(look.line()));
    }

    private CostCurves overThreads(World site) {
        CostCurves.Points view = new CostCurves.Points("static view, full HD");
        CostCurves.Points level = new CostCurves.Points("sound, level model");
        CostCurves.Points energy = new CostCurves.Points("sound, energy model");
        CostCurves.Points build = new CostCurves.Points("tree build");
        Drone drone = droneAt(new Position(0, DRONE_DISTANCE, 0), site);
        Position position = above(site, 0, 0, 2.0);
        AcousticSensor byLevel = AcousticSettings.at(position)
                .withPropagation(LevelModel.DEFAULT.withRays(1000, 10))
                .create();
        AcousticSensor byEnergy = AcousticSettings.at(position)
                .withPropagation(EnergyModel.DEFAULT.withRays(40_000).withAccuracy(0.0))
                .create();
        double[] alone = new double[4];
        for (int threads = 1; threads <= Runtime.getRuntime().availableProcessors(); threads++) {
            progress.accept(Counted.of(threads, "thread"));
            double[] times;
            try (Workers workers = new Workers(threads)) {
                times = workers.call(() -> new double[] {
                    watch.seconds(() -> CameraSettings.at(position).create().depthImage(site, List.of())),
                    watch.seconds(() -> byLevel.listenFully(site, drone, new SplittableRandom(1), RayRecorder.NONE)),
                    watch.seconds(() -> byEnergy.read(site, drone, new SplittableRandom(1))),
                    watch.seconds(() -> KDTree.of(site.mesh()))
                });
            }
            alone = threads == 1 ? times : alone;
            List<CostCurves.Points> lines = List.of(view, level, energy, build);
            for (int i = 0; i < times.length; i++) {
                lines.get(i).add(threads, alone[i] / times[i]);
            }
        }
        return new CostCurves(
                "threads",
                "Speed-up with more threads",
                "threads",
                "speed-up",
                List.of(view.line(), level.line(), energy.line(), build.line()));
    }

    /** Eight drones side by side, the next eight above them. */
    private static Position inRows(int number) {
        int row = number / 8;
        return new Position(4.0 * (number % 8) - 14.0, DRONE_DISTANCE / 4, 3.0 * row);
    }

    /** Time of a look of all sensors, us. */
    private double frame(World site, List<Drone> drones, List<? extends Sensor> sensors) {
        return 1e6
                * watch.seconds(() ->
                        Workers.forEach(sensors.size(), i -> sensors.get(i).observe(site, drones, look(i))));
    }

    /** Cameras in a circle about the middle that look at it, or away from it. */
    private static List<Sensor> cameras(World site, int count, boolean away) {
        Position middle = above(site, 0, 0, 20.0);
        return of(count, i -> {
            Position eye = around(site, i, count);
            Position target = away ? eye.plus(eye.minus(middle)) : middle;
            return CameraSettings.at(eye).withLookAt(target).create();
        });
    }

    private static List<Sensor> microphones(World site, int count) {
        return of(count, i -> AcousticSettings.at(around(site, i, count)).create());
    }

    private static Position around(World site, int number, int count) {
        double angle = 2.0 * Math.PI * number / count;
        return above(site, DRONE_DISTANCE * Math.cos(angle), DRONE_DISTANCE * Math.sin(angle), 20.0);
    }

    private static Position above(World site, double x, double y, double metres) {
        return new Position(x, y, site.surfaceHeight(x, y).orElseThrow() + metres);
    }

    private Drone droneAt(Position offset, World site) {
        Position position = above(site, offset.x(), offset.y(), 20.0 + offset.z());
        DroneSettings settings = DroneSettings.of(ModelSettings.of("drone.obj"), new Hover(position, 0.0));
        return settings.create("drone", droneTree);
    }

    private static Look look(int number) {
        return Look.of(number, "sensor", 0, 0.0);
    }

    private static <T> List<T> of(int count, IntFunction<T> make) {
        List<T> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            all.add(make.apply(i));
        }
        return all;
    }
}
