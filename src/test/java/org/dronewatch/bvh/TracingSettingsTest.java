package org.dronewatch.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.KDTreeStats;
import org.dronewatch.kdtree.SahCost;
import org.dronewatch.kdtree.SequentialTraversal;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How rays are traced changes no result. */
class TracingSettingsTest {
    /** A camera and a microphone with many rays. In the long form also the cameras round the house on the hill. */
    private static final List<String> SCENES =
            LongForm.IS_ON ? List.of("multi-sensor", "closed-space") : List.of("closed-space");

    /** By scene, all that its sensors observe. */
    private static Map<String, List<Observation>> results(String... settings) {
        Map<String, List<Observation>> results = new TreeMap<>();
        for (String scene : SCENES) {
            SceneRunner runner = new SceneRunner(
                    PackagedScene.find(scene).orElseThrow().factory().get());
            runner.set("run.duration", LongForm.IS_ON ? "1 s" : "0.1 s");
            if (!LongForm.IS_ON) {
                runner.set("sensors.camera.width", "300").set("sensors.camera.height", "300");
                runner.set("sensors.microphone.propagation.initialRays", "4");
            }
            for (String setting : settings) {
                String[] parts = setting.split("=", 2);
                runner.set(parts[0], parts[1]);
            }
            List<Observation> observed = new ArrayList<>();
            runner.onFrame(frame -> observed.addAll(frame.observations())).run();
            assertThat(observed).as(scene).isNotEmpty();
            results.put(scene, observed);
        }
        return results;
    }

    @Test
    void everyTraversalAndTreeHasTheSameObservations() {
        Map<String, List<Observation>> fastest = results();

        assertThat(results("world.tracing.traversal=stack")).isEqualTo(fastest);
        if (LongForm.IS_ON) {
            assertThat(results("world.tracing.traversal=sequential")).isEqualTo(fastest);
        }
        assertThat(results("world.tracing.costs.traversal=20", "world.tracing.costs.intersection=1"))
                .isEqualTo(fastest);
    }

    @Test
    void theCostsShapeTheTree() {
        TriangleMesh mesh = new ModelLoader(Path.of(""))
                .loadAsWritten("packaged:quadrotor.obj")
                .mesh();
        KDTreeStats byDefault = KDTreeStats.of(KDTree.of(mesh));
        KDTreeStats dearSteps = KDTreeStats.of(KDTree.of(mesh, new SahCost(40.0, 1.5)));
        KDTreeStats sameRatio = KDTreeStats.of(KDTree.of(mesh, new SahCost(8.0, 3.0)));

        assertThat(dearSteps.leaves()).isLessThan(byDefault.leaves() / 2);
        assertThat(dearSteps.meanLeafSize()).isGreaterThan(2.0 * byDefault.meanLeafSize());
        assertThat(sameRatio.leaves()).isEqualTo(byDefault.leaves());
        assertThat(sameRatio.sahCost()).isEqualTo(2.0 * byDefault.sahCost());
    }

    @Test
    void theTraversalIsTheOneThatWasSet() {
        TriangleMesh mesh = new ModelLoader(Path.of(""))
                .loadAsWritten("packaged:quadrotor.obj")
                .mesh();
        TracingSettings settings = TracingSettings.DEFAULT;
        TracingIndex stack = TracingIndex.of(mesh, settings.withTraversal(RayTraversal.STACK));
        TracingIndex sequential = TracingIndex.of(mesh, settings.withTraversal(RayTraversal.SEQUENTIAL));

        assertThat(stack.newRayTracer()).isInstanceOf(StackTraversal.class);
        assertThat(stack.newIncoherentRayTracer()).isInstanceOf(StackTraversal.class);
        assertThat(sequential.newRayTracer()).isInstanceOf(SequentialTraversal.class);
        assertThat(sequential.newIncoherentRayTracer()).isInstanceOf(SequentialTraversal.class);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -1.0, 1001.0, Double.NaN})
    void aCostBeyondItsLimitsIsRefused(double cost) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SahCost(cost, 1.0))
                .withMessageContaining("traversal");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SahCost(1.0, cost))
                .withMessageContaining("intersection");
    }
}
