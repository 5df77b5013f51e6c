package org.dronewatch.scene;

import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.mission.Mission;
import org.dronewatch.flight.track.Track;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.rf.OccupiedBand;
import org.dronewatch.setting.In;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.NoiseSource;

/**
 * Random scenes that keep all limits: of every kind of sensor, flight, propagation and so on that there is, made from
 * the settings records' own components and limits. Ordinary values, values at a limit and values near it are mixed.
 * They are small, so that thousands can run: few pixels, few rays, a handful of looks.
 *
 * <p>The same seed gives the same scene. A scene names the files that {@link #writeFiles} writes: models of the world
 * and of a drone, and a recorded flight. It may still break a rule between several settings (a mount that listens to
 * itself), which reading reports.
 */
public final class RandomScenes {
    /** Name of the file of the world's model. */
    public static final String MODEL = "site.obj";

    /** Name of the file of a drone's model. */
    public static final String BOX = "box.obj";

    /** A flat square of 200 m with a wall and a roof on it, of two materials. */
    public static final String MODEL_TEXT = "v -100 0 -100\nv 100 0 -100\nv 100 0 100\nv -100 0 100\n"
            + "v -8 0 -12\nv 8 0 -12\nv 8 6 -12\nv -8 6 -12\nv -8 6 -18\nv 8 6 -18\n"
            + "usemtl grass\nf 1 4 3 2\nusemtl brick_rough\nf 5 6 7 8\nf 8 7 10 9\n";

    /** A box of 60 x 30 x 40 cm. */
    public static final String BOX_TEXT = "v -0.3 -0.15 -0.2\nv 0.3 -0.15 -0.2\nv 0.3 0.15 -0.2\nv -0.3 0.15 -0.2\n"
            + "v -0.3 -0.15 0.2\nv 0.3 -0.15 0.2\nv 0.3 0.15 0.2\nv -0.3 0.15 0.2\n"
            + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

    /** Name of the file of a recorded flight. */
    public static final String FLIGHTS = "flights.csv";

    /** A flight of five seconds over the square, by way of one corner. */
    public static final String FLIGHTS_TEXT =
            "run,drone,time_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,yaw_rad,pitch_rad,roll_rad,gliding_s\n"
                    + "0,d,0,-20,5,10,10,0,1,0,0,0,\n0,d,2,0,5,12,0,-5,0,0,0,0,\n0,d,5,0,-10,12,0,0,0,0,0,0,\n";

    private static final int ATTEMPTS = 60;
    private static final int LOOKS = 3;
    private static final double FAR = 30.0;

    /** What would make a scene slow, by record and component: the most that is drawn. */
    private static final Map<String, Double> SMALL = Map.ofEntries(
            Map.entry("width", 48.0),
            Map.entry("height", 27.0),
            Map.entry("EnergyModel.rays", 40.0),
            Map.entry("EnergyModel.maxOrder", 20.0),
            Map.entry("LevelModel.initialRays", 3.0),
            Map.entry("LevelModel.reflectionsPerHit", 2.0),
            Map.entry("LevelModel.maxOrder", 3.0),
            Map.entry("LevelModel.rayBudget", 300.0),
            Map.entry("Swarm.count", 4.0),
            Map.entry("TerrainFollowing.height", 100.0),
            Map.entry("LowApproach.distance", 2000.0));

    /** What would need files of its own. */
    private static final Set<String> LEFT_OUT = Set.of("WorldSettings.terrain", "WorldSettings.buildings");

    /** Flights whose files state latitudes and longitudes: most are nowhere near a site with a random origin. */
    private static final Set<Class<?>> PLACED_FLIGHTS = Set.of(Mission.class, Track.class);

    private final SplittableRandom random;
    private final Kinds kinds = SensorKinds.kinds(Catalog.packaged());
    private final List<String> sensorIds = new ArrayList<>();

    private RandomScenes(long seed) {
        this.random = new SplittableRandom(seed);
    }

    /** The scene of a seed. */
    public static SceneSettings of(long seed) {
        return new RandomScenes(seed).scene();
    }

    /** The scene of a seed as a scene file, in YAML. */
    public static String yaml(long seed) {
        return SettingsText.of(of(seed), SensorKinds.kinds(Catalog.packaged()));
    }

    /** Writes the files that the scenes name into the directory of a scene. */
    public static void writeFiles(Path directory) throws IOException {
        Files.writeString(directory.resolve(MODEL), MODEL_TEXT);
        Files.writeString(directory.resolve(BOX), BOX_TEXT);
        Files.writeString(directory.resolve(FLIGHTS), FLIGHTS_TEXT);
    }

    private SceneSettings scene() {
        int sensors = 1 + random.nextInt(3);
        for (int i = 0; i < sensors; i++) {
            sensorIds.add("s" + i);
        }
        IllegalArgumentException last = null;
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            try {
                SceneSettings drawn = (SceneSettings) record(SceneSettings.class);
                if (random.nextInt(6) == 0) {
                    drawn = drawn.withEnabled(oneOf(sensorIds), false);
                }
                return SceneSettingsDuration.of(drawn, duration(drawn));
            } catch (IllegalArgumentException e) {
                // A rule between settings was broken: draw again.
                last = e;
            }
        }
        throw new IllegalStateException("no valid scene in " + ATTEMPTS + " attempts", last);
    }

    /** As long as the fastest sensor needs for some looks, within the limits. */
    private double duration(SceneSettings scene) {
        double fastest = scene.sensors().values().stream()
                .mapToDouble(SensorSettings::rate)
                .max()
                .orElse(1.0);
        double looks = random.nextInt(8) == 0 ? Double.MIN_VALUE : random.nextDouble() * LOOKS;
        return Math.max(Double.MIN_VALUE, Math.min(1e6, looks / fastest));
    }

    private Record record(Class<?> type) {
        SettingsForm form = SettingsForm.of(type);
        IllegalArgumentException last = null;
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            // The more attempts fail, the more is left as it is by default.
            int kept = attempt < ATTEMPTS / 2 ? 2 : 1;
            Map<String, Object> values = new LinkedHashMap<>();
            for (RecordComponent part : form.parts()) {
                String name = type.getSimpleName() + "." + part.getName();
                if (LEFT_OUT.contains(name)) {
                    continue;
                }
                boolean isNeeded = form.required().contains(part.getName())
                        || type == SceneSettings.class
                        || name.equals("WorldSettings.models");
                if (isNeeded || isCostly(type, part) || random.nextInt(3) < kept) {
                    draw(type, part).ifPresent(value -> values.put(part.getName(), value));
                }
            }
            try {
                return form.create(values);
            } catch (IllegalArgumentException e) {
                last = e;
            }
        }
        throw new IllegalArgumentException("no valid " + type.getSimpleName() + ": " + last.getMessage(), last);
    }

    private static boolean isCostly(Class<?> type, RecordComponent part) {
        return most(type, part) != null || type == EnergyModel.class || type == LevelModel.class;
    }

    private static Double most(Class<?> type, RecordComponent part) {
        Double most = SMALL.get(type.getSimpleName() + "." + part.getName());
        return most != null || part.getType() != int.class ? most : SMALL.get(part.getName());
    }

    /** A value for a component; empty to leave it as it is by default. */
    private Optional<Object> draw(Class<?> type, RecordComponent part) {
        String name = type.getSimpleName() + "." + part.getName();
        return switch (name) {
            case "SceneSettings.sensors" -> Optional.of(byId(sensorIds, SensorSettings.class));
            case "SceneSettings.drones" ->
                Optional.of(byId(random.nextInt(4) == 0 ? List.of("d", "e") : List.of("d"), DroneSettings.class));
            case "SceneSettings.run", "SceneSettings.sweep" -> Optional.empty();
            case "PriceSettings.currency" -> Optional.of("EUR");
            case "PriceSettings.sensors" -> Optional.of(Map.of(oneOf(sensorIds), random.nextDouble() * 1e4));
            case "PositionerSettings.cues" -> Optional.of(random.nextBoolean() ? List.of() : List.of(oneOf(sensorIds)));
            case "WorldSettings.models" -> Optional.of(List.of(model(MODEL)));
            case "DroneSettings.model" -> Optional.of(model(BOX));
            case "DroneSettings.sound" -> Optional.of(oneOf(List.copyOf(DroneSounds.names())));
            case "SurfaceSettings.materials" -> Optional.of(Map.of("grass", surface()));
            case "SurfaceSettings.own" -> Optional.of(Map.of("brick_rough", record(OwnSurface.class)));
            case "RfSettings.occupied" -> Optional.of(Map.of("lan", record(OccupiedBand.class)));
            case "Recorded.file" -> Optional.of(FLIGHTS);
            case "Recorded.drone" -> Optional.of(Optional.of("d"));
            case "Recorded.run" -> Optional.of(0);
            case "AlertSettings.zones" -> Optional.of(zones());
            case "WorldSettings.noiseSources" -> Optional.of(noiseSources());
            case "OwnSurface.absorption" ->
                Optional.of(Optional.of(BandFractions.flat(0.1 + 0.9 * random.nextDouble())));
            case "OwnSurface.absorptionByAngle" -> Optional.of(List.of());
            case "OwnSurface.transmissionLoss" ->
                Optional.of(Optional.of(BandLevels.flat(10.0 + 90.0 * random.nextDouble())));
            case "SurfaceSettings.defaultSurface" -> Optional.of(surface());
            default -> Optional.of(value(part.getGenericType(), part, type));
        };
    }

    private Map<String, NoiseSource> noiseSources() {
        List<Position> road = List.of(new Position(9, 9, 9), new Position(9, 9 + 20 * random.nextDouble(), 10));
        return random.nextBoolean()
                ? Map.of()
                : Map.of(
                        "road",
                        NoiseSource.along(road, 100 * random.nextDouble()).withSoundLevel(40));
    }

    /** Areas on the square, whose outlines cannot cross themselves. */
    private Map<String, ProtectedArea> zones() {
        Map<String, ProtectedArea> zones = new LinkedHashMap<>();
        if (random.nextBoolean()) {
            List<GroundPoint> corners = List.of(
                    new GroundPoint(number(FAR), -1 - FAR * random.nextDouble()),
                    new GroundPoint(1 + FAR * random.nextDouble(), number(FAR)),
                    new GroundPoint(-1 - FAR * random.nextDouble(), FAR + 1));
            zones.put("field", ProtectedArea.polygon(corners, 1e-9 + 100 * random.nextDouble()));
        }
        if (random.nextInt(3) == 0) {
            GroundPoint centre = new GroundPoint(number(FAR), number(FAR));
            double floor = FAR * random.nextDouble();
            zones.put(
                    "round",
                    new ProtectedArea(
                            List.of(),
                            Optional.of(centre),
                            Optional.of(0.1 + FAR * random.nextDouble()),
                            floor,
                            2 * FAR));
        }
        return zones;
    }

    private String surface() {
        return oneOf(List.copyOf(SurfaceMaterials.names()));
    }

    private ModelSettings model(String file) {
        ModelSettings plain = ModelSettings.of(file);
        if (random.nextInt(4) > 0) {
            return plain;
        }
        ModelSettings drawn = (ModelSettings) SettingsForm.of(ModelSettings.class)
                .create(Map.of(
                        "file", file,
                        "upAxis",
                                oneOf(List.of(ModelSettings.of(file)
                                        .upAxis()
                                        .getDeclaringClass()
                                        .getEnumConstants())),
                        "heading", number(In.TWO_TURNS)));
        return random.nextInt(4) > 0 ? drawn : drawn.withScale(Math.pow(10.0, 12.0 * random.nextDouble() - 6.0));
    }

    private double number(double most) {
        return (2.0 * random.nextDouble() - 1.0) * most;
    }

    private Map<String, Object> byId(List<String> ids, Class<?> type) {
        Map<String, Object> values = new LinkedHashMap<>();
        ids.forEach(id -> values.put(id, oneOfType(type)));
        return values;
    }

    private Object value(Type type, RecordComponent part, Class<?> owner) {
        if (type instanceof ParameterizedType several) {
            Type inner = several.getActualTypeArguments()[0];
            if (several.getRawType() == Optional.class) {
                return random.nextBoolean() ? Optional.empty() : Optional.of(value(inner, part, owner));
            }
            if (several.getRawType() == List.class) {
                List<Object> values = new ArrayList<>();
                int count = (inner == Double.class ? 1 : 2) + random.nextInt(3);
                for (int i = 0; i < count; i++) {
                    values.add(value(inner, part, owner));
                }
                return values;
            }
            return value(several.getRawType(), part, owner);
        }
        Class<?> plain = (Class<?>) type;
        if (plain == double.class || plain == Double.class) {
            return number(part.getAnnotation(In.class), most(owner, part));
        }
        if (plain == int.class) {
            return (int) Math.rint(number(part.getAnnotation(In.class), most(owner, part)));
        }
        if (plain == long.class) {
            return random.nextLong();
        }
        if (plain == boolean.class || plain == Boolean.class) {
            return random.nextBoolean();
        }
        if (plain.isEnum()) {
            return oneOf(List.of(plain.getEnumConstants()));
        }
        if (plain == org.dronewatch.geometry.Position.class && random.nextInt(12) > 0) {
            return new org.dronewatch.geometry.Position(number(FAR), number(FAR), random.nextDouble() * FAR);
        }
        if (plain == GroundPoint.class && random.nextInt(12) > 0) {
            return new GroundPoint(number(FAR), number(FAR));
        }
        if (!kinds.isChoice(plain) && !plain.isRecord()) {
            throw new IllegalStateException(owner.getSimpleName() + "." + part.getName() + ": draw a value for it");
        }
        return oneOfType(plain);
    }

    /** A record of a type, or of one of the kinds of an interface. */
    private Record oneOfType(Class<?> type) {
        if (kinds.isChoice(type)) {
            return record(oneOf(kinds.of(type).values().stream()
                    .filter(kind -> !PLACED_FLIGHTS.contains(kind))
                    .toList()));
        }
        return record(type);
    }

    /** A number within limits: at one, next to one, anywhere between, or of any order of size. */
    private double number(In limits, Double most) {
        double low = Math.max(limits.from(), Math.nextUp(limits.above()));
        double high = Math.min(limits.to(), Math.nextDown(limits.below()));
        if (most != null) {
            high = Math.min(high, most);
        }
        double between = low + random.nextDouble() * (high - low);
        double small = Math.pow(10.0, random.nextDouble() * 12.0 - 9.0);
        double drawn =
                switch (random.nextInt(12)) {
                    case 0 -> low;
                    case 1 -> high;
                    case 2 -> Math.nextUp(low);
                    case 3 -> Math.nextDown(high);
                    case 4 -> 0.0;
                    case 5, 6, 7 -> low > 0.0 || high < 0.0 ? low * Math.pow(high / low, random.nextDouble()) : small;
                    case 8 -> Math.min(high, Math.max(low, 1.0)) * (0.5 + random.nextDouble());
                    default -> between;
                };
        return Double.isFinite(drawn) ? Math.min(high, Math.max(low, drawn)) : between;
    }

    private <T> T oneOf(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }

    /** Makes the same scene last otherwise. */
    private static final class SceneSettingsDuration {
        static SceneSettings of(SceneSettings scene, double seconds) {
            return SettingsForm.with(scene, "run", scene.run().withDuration(seconds));
        }
    }
}
