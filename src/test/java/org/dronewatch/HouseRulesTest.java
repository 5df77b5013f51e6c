package org.dronewatch;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.ThreatLabel;

/** The rooms of the house and the one way in which they may know each other. */
@AnalyzeClasses(packages = "org.dronewatch", importOptions = ImportOption.DoNotIncludeTests.class)
class HouseRulesTest {
    private static final String HOUSE = "org.dronewatch.";

    /**
     * The rooms from the roof to the ground. A line is a storey: its rooms lie side by side and do not know each other, but for
     * those of the ground floor.
     */
    private static final List<List<String>> STOREYS = List.of(
            List.of("app.."),
            List.of("viewer.."),
            List.of("report.."),
            List.of("bench..", "models..", "render.."),
            List.of("analysis..", "scenes.."),
            List.of("scene"),
            List.of("run"),
            List.of("scenario"),
            List.of("catalog"),
            List.of("fusion"),
            List.of("sensor.camera..", "sensor.thermal..", "sensor.radar..", "sensor.rf..", "sensor.acoustic.."),
            List.of("sensor.optics"),
            List.of("sensor"),
            List.of("positioner"),
            List.of("drone"),
            List.of("flight"),
            List.of("world"),
            List.of("mesh.io", "geo"),
            List.of("bvh", "raster"),
            List.of("kdtree"),
            List.of("sound", "geometry", "parallel", "setting.."));

    @ArchTest
    static void arrowsLeadDown(JavaClasses house) {
        int ground = STOREYS.size() - 1;
        List<String> above = new ArrayList<>();
        for (int storey = 0; storey <= ground; storey++) {
            for (String room : STOREYS.get(storey)) {
                List<String> forbidden = new ArrayList<>(above);
                if (storey < ground) {
                    STOREYS.get(storey).stream()
                            .filter(other -> !other.equals(room))
                            .forEach(forbidden::add);
                }
                if (!forbidden.isEmpty()) {
                    noClasses()
                            .that()
                            .resideInAPackage(HOUSE + room)
                            .should()
                            .dependOnClassesThat()
                            .resideInAnyPackage(forbidden.stream()
                                    .map(other -> HOUSE + other)
                                    .toArray(String[]::new))
                            .allowEmptyShould(true)
                            .check(house);
                }
            }
            above.addAll(STOREYS.get(storey));
        }
    }

    @ArchTest
    static void everyClassIsInARoom(JavaClasses house) {
        classes()
                .should()
                .resideInAnyPackage(STOREYS.stream()
                        .flatMap(List::stream)
                        .map(room -> HOUSE + room)
                        .toArray(String[]::new))
                .check(house);
    }

    @ArchTest
    static final ArchRule NO_CIRCLES =
            slices().matching("org.dronewatch.(**)").should().beFreeOfCycles();

    @ArchTest
    static final ArchRule NO_SENSOR_KNOWS_WHAT_A_DRONE_WANTS = noClasses()
            .that()
            .resideInAPackage("org.dronewatch.sensor..")
            .should()
            .dependOnClassesThat()
            .areAssignableTo(ThreatLabel.class)
            .orShould()
            .callMethod(DroneSettings.class, "label");

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
