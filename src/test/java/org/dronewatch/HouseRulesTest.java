package org.dronewatch;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dronewatch.House.Storey;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.fusion.ForecastLog;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.run.AlertWatch;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Detection;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.tracking.AssessedLook;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.ContactMatcher;
import org.dronewatch.tracking.PerfectAssociation;
import org.dronewatch.world.Visibility;
import org.jogamp.vecmath.Tuple3d;

/** The rooms of the house and the one way in which they may know each other. */
@AnalyzeClasses(packages = "org.dronewatch", importOptions = ImportOption.DoNotIncludeTests.class)
class HouseRulesTest {
    private static final String DISPATCH = "org.dronewatch.run.ContactDispatch";
    private static final String TRIALS = "org.dronewatch.run.ConfirmationTrials";
    private static final String PAINTER = "org.dronewatch.render.SitePainter";

    /** Who traces rays that have no other end: names in regular expressions. */
    private static final List<String> TRACERS = List.of(
            "bench\\..*",
            "render\\.SitePainter",
            "render\\.photo\\.Shading",
            "report\\.sheet\\.ReliefShade",
            "sensor\\.acoustic\\.energy\\.ReceiverSphere",
            "sensor\\.acoustic\\.propagation\\.AcousticRay",
            "sensor\\.optics\\.VisibleArea",
            "world\\.Clearance",
            "world\\.SurfaceColumn",
            "world\\.Surroundings",
            "world\\.Visibility",
            "world\\.World");

    /** Who accepts or returns tuples of vecmath: names in regular expressions. */
    private static final List<String> TUPLES = List.of(
            "bench\\..*",
            "geometry\\..*",
            "drone\\.Drone",
            "kdtree\\.RayTracer",
            "sensor\\.optics\\.CameraObject",
            "world\\.World");

    private static final String[] KERNEL = {"org.dronewatch.kdtree", "org.dronewatch.bvh", "org.dronewatch.raster"};

    @ArchTest
    static void everyRoomUsesOnlyThoseBelowIt(JavaClasses house) {
        for (Storey storey : House.STOREYS) {
            for (String room : storey.rooms()) {
                String[] forbidden = House.forbidden(storey, room).stream()
                        .map(House.NAME::concat)
                        .toArray(String[]::new);
                if (forbidden.length > 0) {
                    noClasses()
                            .that()
                            .resideInAPackage(House.NAME + room)
                            .should()
                            .dependOnClassesThat()
                            .resideInAnyPackage(forbidden)
                            .allowEmptyShould(true)
                            .check(house);
                }
            }
        }
    }

    @ArchTest
    static void everyClassIsInARoom(JavaClasses house) {
        classes()
                .should()
                .resideInAnyPackage(House.STOREYS.stream()
                        .flatMap(storey -> storey.rooms().stream())
                        .map(House.NAME::concat)
                        .toArray(String[]::new))
                .check(house);
    }

    @ArchTest
    static final ArchRule NO_CIRCLES =
            slices().matching("org.dronewatch.(**)").should().beFreeOfCycles();

    /** A reader who looks for a type by its name finds one. */
    @ArchTest
    static void noTwoTypesHaveOneName(JavaClasses house) {
        Map<String, List<String>> named = house.stream()
                .filter(JavaClass::isTopLevelClass)
                .filter(HouseRulesTest::hasSource)
                .collect(groupingBy(JavaClass::getSimpleName, TreeMap::new, mapping(JavaClass::getName, toList())));
        named.values().removeIf(names -> names.size() == 1);

        assertThat(named).as("types that share their name").isEmpty();
    }

    /** Not so of a class that was moved since the build last began from nothing, nor of a package's description. */
    private static boolean hasSource(JavaClass type) {
        return Files.exists(Path.of("src", "main", "java", type.getName().replace('.', '/') + ".java"))
                && !type.getSimpleName().equals("package-info");
    }

    /**
     * Kinds of sensors and emissions, which users may add, are asked for their capabilities, not for their class; only
     * a packaged scene knows the kinds that it has itself chosen.
     */
    @ArchTest
    static void nobodyTestsForAKind(JavaClasses house) {
        List<String> tests = house.stream()
                .filter(type -> !type.getPackageName().equals("org.dronewatch.scenes"))
                .flatMap(type -> type.getInstanceofChecks().stream())
                .filter(check -> Stream.of(SensorSettings.class, SoundEmission.class)
                        .anyMatch(kind -> check.getRawType().isAssignableTo(kind)))
                .filter(check -> !check.getRawType()
                        .getPackageName()
                        .equals(check.getOwner().getOwner().getPackageName()))
                .map(Object::toString)
                .toList();
        assertThat(tests).isEmpty();
    }

    @ArchTest
    static final ArchRule NO_SENSOR_KNOWS_WHAT_A_DRONE_WANTS = noClasses()
            .that()
            .resideInAPackage("org.dronewatch.sensor..")
            .should()
            .dependOnClassesThat()
            .areAssignableTo(ThreatLabel.class)
            .orShould()
            .callMethod(DroneSettings.class, "label");

    /**
     * Description, run and simulator can each be read from the first file to the last. {@code Scene.run()} is a
     * convenience of one line for {@code new GateWatch().run()}, and the only exception.
     */
    @ArchTest
    static final ArchRule NO_CIRCLES_OF_FILES = slices().assignedFrom(new FileOfTheRun())
            .should()
            .beFreeOfCycles()
            .ignoreDependency(Scene.class, SceneRunner.class);

    /** Puts each file of description, run and simulator into a slice of its own. */
    private static final class FileOfTheRun implements SliceAssignment {
        private static final Set<String> ROOMS =
                Set.of("org.dronewatch.scenario", "org.dronewatch.run", "org.dronewatch.scene");

        @Override
        public SliceIdentifier getIdentifierOf(JavaClass one) {
            JavaClass file = one;
            while (file.getEnclosingClass().isPresent()) {
                file = file.getEnclosingClass().get();
            }
            return ROOMS.contains(one.getPackageName()) ? SliceIdentifier.of(file.getName()) : SliceIdentifier.ignore();
        }

        @Override
        public String getDescription() {
            return "files of scenario, run and scene";
        }
    }

    /** From what mounts and alerts are handed, the truth cannot be reached. */
    @ArchTest
    static final ArchRule MOUNTS_AND_ALERTS_DO_NOT_KNOW_THE_TRUTH = noClasses()
            .that()
            .resideInAnyPackage("org.dronewatch.positioner", "org.dronewatch.fusion", "org.dronewatch.tracking")
            .and()
            .doNotBelongToAnyOf(PerfectAssociation.class)
            .should()
            .dependOnClassesThat()
            .belongToAnyOf(Observation.class, GroundTruth.class, Detection.class)
            .orShould()
            .dependOnClassesThat()
            .resideInAnyPackage("org.dronewatch.drone", "org.dronewatch.flight");

    /**
     * What hands contacts on, and whoever receives them: neither a field nor a parameter nor a result leads to the
     * truth, nor to what only scoring may know, through however many types.
     */
    @ArchTest
    static final ArchRule NO_PATH_LEADS_FROM_A_CONTACT_TO_THE_TRUTH = classes()
            .that()
            .haveFullyQualifiedName(DISPATCH)
            .or()
            .belongToAnyOf(AlertLog.class, Positioner.class, ContactLook.class, ContactMatcher.class)
            .should(new NotReach(Set.of(
                    GroundTruth.class,
                    Observation.class,
                    Detection.class,
                    Drone.class,
                    PerfectAssociation.class,
                    AssessedLook.class,
                    ForecastLog.class)));

    /**
     * A number or a flag can tell the truth as well as an object that holds it, and no path of types would show it: a
     * look has nothing but its contact, its sensor, its time and what the sensor measured.
     */
    @ArchTest
    static void aContactLookHasNothingButMeasurements(JavaClasses house) {
        assertThat(house.get(ContactLook.class).getFields())
                .extracting(field -> field.getType().getName() + " " + field.getName())
                .containsExactlyInAnyOrder(
                        "int contact",
                        "java.lang.String sensor",
                        "double time",
                        "java.util.List<" + Measurement.class.getName() + "> measurements");
    }

    /** How likely a look was to detect a drone that it did not detect, no sensor knows: only scores depend on it. */
    @ArchTest
    static final ArchRule ONLY_SCORES_DEPEND_ON_ASSESSMENTS = classes()
            .that()
            .belongToAnyOf(AssessedLook.class)
            .should()
            .onlyHaveDependentClassesThat()
            .belongToAnyOf(AssessedLook.class, PerfectAssociation.class, ForecastLog.class);

    /** The forecast is a score. */
    @ArchTest
    static final ArchRule ONLY_THE_WATCH_OVER_ALERTS_FORECASTS = classes()
            .that()
            .belongToAnyOf(ForecastLog.class)
            .should()
            .onlyHaveDependentClassesThat()
            .belongToAnyOf(ForecastLog.class, AlertWatch.class);

    /**
     * Positioners and alert rules are informed by contacts alone. Trials of other rules are scores: they change nothing
     * in a run.
     */
    @ArchTest
    static final ArchRule ONLY_CONTACTS_STEER_AND_ALERT = noClasses()
            .that()
            .doNotHaveFullyQualifiedName(DISPATCH)
            .and()
            .doNotHaveFullyQualifiedName(TRIALS)
            .should()
            .callMethodWhere(DescribedPredicate.describe(
                    "a positioner or an alert rule is informed",
                    call -> call.getTargetOwner().isEquivalentTo(Positioner.class)
                                    && Set.of("see", "cue").contains(call.getName())
                            || call.getTargetOwner().isEquivalentTo(AlertLog.class)
                                    && call.getName().equals("add")));

    /**
     * What stands between two points, {@link Visibility} says: what counts at the ends is decided once. The painter's
     * shadows begin at depths of single precision, and have a margin of their own; a benchmark of the kernel measures
     * nothing else.
     */
    @ArchTest
    static final ArchRule ONLY_VISIBILITY_ASKS_THE_KERNEL_FOR_OCCLUSION = noClasses()
            .that()
            .resideOutsideOfPackages(KERNEL)
            .and()
            .resideOutsideOfPackage("org.dronewatch.bench")
            .and()
            .doNotBelongToAnyOf(Visibility.class)
            .and()
            .doNotHaveFullyQualifiedName(PAINTER)
            .should()
            .callMethodWhere(ofARayTracer("isOccluded"));

    /**
     * Rays, which have no other end, go to the kernel itself: those of sound, of pictures, from above, and about a
     * point.
     */
    @ArchTest
    static final ArchRule ONLY_THESE_TRACE_RAYS = classes()
            .that()
            .resideOutsideOfPackages(KERNEL)
            .and(traceRays())
            .should()
            .haveNameMatching(anyOf(TRACERS));

    private static DescribedPredicate<JavaClass> traceRays() {
        return DescribedPredicate.describe(
                "trace rays", one -> one.getMethodCallsFromSelf().stream().anyMatch(ofARayTracer("closestHit")));
    }

    private static String anyOf(List<String> names) {
        return "org\\.dronewatch\\.(" + String.join("|", names) + ")";
    }

    private static DescribedPredicate<JavaMethodCall> ofARayTracer(String method) {
        return DescribedPredicate.describe(
                "RayTracer." + method,
                call -> call.getName().equals(method) && call.getTargetOwner().isAssignableTo(RayTracer.class));
    }

    /**
     * Points and displacements are {@link Position}s, which nobody can change. The tuples of vecmath are for callers of
     * drones, of rays, of the world and of cameras, and for pictures; poses are its matrices everywhere.
     */
    @ArchTest
    static final ArchRule POINTS_ARE_POSITIONS_INSIDE =
            classes().that(useTuples()).should().haveNameMatching(anyOf(TUPLES));

    private static DescribedPredicate<JavaClass> useTuples() {
        return DescribedPredicate.describe("use tuples of vecmath", one -> one.getDirectDependenciesFromSelf().stream()
                .anyMatch(use -> use.getTargetClass().isAssignableTo(Tuple3d.class)));
    }

    /** A rule that names what has been renamed would keep nothing any more. */
    @ArchTest
    static void whatRulesNameIsThere(JavaClasses house) {
        assertThat(List.of(DISPATCH, TRIALS, PAINTER)).allMatch(house::contain);
        assertNamesAreUsed(house, TRACERS, traceRays());
        assertNamesAreUsed(house, TUPLES, useTuples());
        assertHasMethods(house, DroneSettings.class, "label");
        assertHasMethods(house, Positioner.class, "see", "cue");
        assertHasMethods(house, AlertLog.class, "add");
        assertHasMethods(house, RayTracer.class, "isOccluded", "closestHit");
    }

    private static void assertNamesAreUsed(
            JavaClasses house, List<String> names, DescribedPredicate<JavaClass> predicate) {
        assertThat(names).as("classes that %s", predicate.getDescription()).allMatch(name -> house.stream()
                .filter(predicate)
                .anyMatch(type -> type.getName().matches(anyOf(List.of(name)))));
    }

    private static void assertHasMethods(JavaClasses house, Class<?> type, String... names) {
        assertThat(house.get(type).getAllMethods())
                .extracting(JavaMethod::getName)
                .contains(names);
    }

    @ArchTest
    static final ArchRule ONLY_CAMERAS_PROJECT = noClasses()
            .that()
            .doNotBelongToAnyOf(CameraObject.class)
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.joml..");

    @ArchTest
    static final ArchRule ONLY_GEO_KNOWS_THE_LIBRARY_OF_PROJECTIONS = noClasses()
            .that()
            .resideOutsideOfPackage("org.dronewatch.geo")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.locationtech.proj4j..");

    @ArchTest
    static final ArchRule ONLY_TERRAIN_KNOWS_THE_DECODER_OF_TIFF = noClasses()
            .that()
            .resideOutsideOfPackage("org.dronewatch.terrain.io")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("com.twelvemonkeys..");

    @ArchTest
    static final ArchRule ONLY_THE_SCENE_KNOWS_DSOL = noClasses()
            .that()
            .resideOutsideOfPackage("org.dronewatch.scene")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("nl.tudelft..");

    @ArchTest
    static final ArchRule NOTHING_BELOW_THE_VIEWER_KNOWS_SWING = noClasses()
            .that()
            .resideOutsideOfPackages("org.dronewatch.app..", "org.dronewatch.viewer..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("javax.swing..");

    @ArchTest
    static final ArchRule GENERATED_MODELS_STAND_ALONE = classes()
            .that()
            .resideInAPackage("org.dronewatch.models..")
            .should()
            .onlyDependOnClassesThat()
            .resideInAnyPackage("org.dronewatch.models..", "java..");

    @ArchTest
    static final ArchRule ONLY_THE_COMMAND_LINE_ENDS_THE_PROCESS = noClasses()
            .that()
            .resideOutsideOfPackage("org.dronewatch.app")
            .should()
            .callMethod(System.class, "exit", int.class);
}
