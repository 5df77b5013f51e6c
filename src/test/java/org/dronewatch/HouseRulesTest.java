package org.dronewatch;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import org.dronewatch.world.DroneSettings;
import org.dronewatch.world.ThreatLabel;

/** The rooms of the house and the one way in which they may know each other. */
@AnalyzeClasses(packages = "org.dronewatch", importOptions = ImportOption.DoNotIncludeTests.class)
class HouseRulesTest {

    @ArchTest
    static final ArchRule ARROWS_LEAD_DOWN = layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("app")
            .definedBy("org.dronewatch.app..")
            .layer("bench")
            .definedBy("org.dronewatch.bench..")
            .layer("models")
            .definedBy("org.dronewatch.models..")
            .layer("report")
            .definedBy("org.dronewatch.report..")
            .layer("viewer")
            .definedBy("org.dronewatch.viewer..")
            .layer("picture")
            .definedBy("org.dronewatch.picture..")
            .layer("scenes")
            .definedBy("org.dronewatch.scenes..")
            .layer("fusion")
            .definedBy("org.dronewatch.fusion..")
            .layer("scene")
            .definedBy("org.dronewatch.scene..")
            .layer("catalog")
            .definedBy("org.dronewatch.catalog..")
            .layer("camera")
            .definedBy("org.dronewatch.sensor.camera..")
            .layer("acoustic")
            .definedBy("org.dronewatch.sensor.acoustic..")
            .layer("radar")
            .definedBy("org.dronewatch.sensor.radar..")
            .layer("rf")
            .definedBy("org.dronewatch.sensor.rf..")
            .layer("thermal")
            .definedBy("org.dronewatch.sensor.thermal..")
            .layer("optics")
            .definedBy("org.dronewatch.sensor.optics..")
            .layer("positioner")
            .definedBy("org.dronewatch.sensor.positioner..")
            .layer("sensor")
            .definedBy("org.dronewatch.sensor")
            .layer("world")
            .definedBy("org.dronewatch.world..")
            .layer("sound")
            .definedBy("org.dronewatch.sound..")
            .layer("kdtree")
            .definedBy("org.dronewatch.kdtree..")
            .layer("geometry")
            .definedBy("org.dronewatch.geometry..")
            .layer("parallel")
            .definedBy("org.dronewatch.parallel..")
            .layer("setting")
            .definedBy("org.dronewatch.setting..")
            .whereLayer("app")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("bench")
            .mayOnlyBeAccessedByLayers("app", "report")
            .whereLayer("models")
            .mayOnlyBeAccessedByLayers("app")
            .whereLayer("viewer")
            .mayOnlyBeAccessedByLayers("app")
            .whereLayer("report")
            .mayOnlyBeAccessedByLayers("app", "viewer")
            .whereLayer("picture")
            .mayOnlyBeAccessedByLayers("app", "viewer", "report")
            .whereLayer("scenes")
            .mayOnlyBeAccessedByLayers("app")
            .whereLayer("scene")
            .mayOnlyBeAccessedByLayers("viewer", "picture", "app", "report", "scenes")
            .whereLayer("fusion")
            .mayOnlyBeAccessedByLayers("app", "picture", "report", "scenes", "scene", "viewer")
            .whereLayer("catalog")
            .mayOnlyBeAccessedByLayers("picture", "app", "report", "scenes", "scene")
            .whereLayer("camera")
            .mayOnlyBeAccessedByLayers("app", "bench", "scenes", "catalog")
            .whereLayer("thermal")
            .mayOnlyBeAccessedByLayers("app", "scenes", "catalog")
            .whereLayer("optics")
            .mayOnlyBeAccessedByLayers("viewer", "picture", "app", "bench", "scenes", "camera", "thermal")
            .whereLayer("positioner")
            .mayOnlyBeAccessedByLayers(
                    "viewer", "picture", "report", "scene", "catalog", "camera", "optics", "radar", "sensor", "thermal")
            .whereLayer("acoustic")
            .mayOnlyBeAccessedByLayers("app", "bench", "scenes", "catalog")
            .whereLayer("radar")
            .mayOnlyBeAccessedByLayers("app", "scenes", "catalog")
            .whereLayer("rf")
            .mayOnlyBeAccessedByLayers("app", "scenes", "catalog")
            .whereLayer("sensor")
            .mayOnlyBeAccessedByLayers(
                    "viewer",
                    "picture",
                    "app",
                    "bench",
                    "report",
                    "scenes",
                    "scene",
                    "catalog",
                    "camera",
                    "acoustic",
                    "radar",
                    "rf",
                    "optics",
                    "fusion",
                    "thermal")
            .whereLayer("world")
            .mayOnlyBeAccessedByLayers(
                    "viewer",
                    "picture",
                    "app",
                    "bench",
                    "report",
                    "scenes",
                    "scene",
                    "catalog",
                    "camera",
                    "acoustic",
                    "radar",
                    "rf",
                    "sensor",
                    "optics",
                    "thermal")
            .whereLayer("sound")
            .mayOnlyBeAccessedByLayers("scenes", "scene", "acoustic", "sensor", "world")
            .whereLayer("kdtree")
            .mayOnlyBeAccessedByLayers(
                    "viewer",
                    "picture",
                    "app",
                    "bench",
                    "report",
                    "scene",
                    "camera",
                    "acoustic",
                    "radar",
                    "rf",
                    "world",
                    "optics")
            .whereLayer("geometry")
            .mayOnlyBeAccessedByLayers(
                    "viewer",
                    "picture",
                    "app",
                    "bench",
                    "report",
                    "scenes",
                    "scene",
                    "camera",
                    "acoustic",
                    "radar",
                    "rf",
                    "sensor",
                    "world",
                    "kdtree",
                    "optics",
                    "positioner",
                    "fusion",
                    "thermal")
            .whereLayer("parallel")
            .mayOnlyBeAccessedByLayers(
                    "viewer",
                    "picture",
                    "app",
                    "bench",
                    "report",
                    "scene",
                    "camera",
                    "acoustic",
                    "world",
                    "kdtree",
                    "optics");

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
