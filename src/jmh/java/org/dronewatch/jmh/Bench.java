package org.dronewatch.jmh;

import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.bench.RayGenerator;
import org.dronewatch.bench.RaySet;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;

/** What the benchmarks use: the project's models, read from the working directory, and rays of one seed. */
final class Bench {
    private static final Path MODELS = Path.of("models");
    private static final Path SOUND = Path.of("src/test/resources/org/dronewatch/sensor/acoustic/energy");
    private static final long SEED = 1;

    private Bench() {}

    /** A model in the coordinates of its file. */
    static TriangleMesh mesh(String model) {
        return new ModelLoader(MODELS).loadAsWritten(model + ".obj").mesh();
    }

    /** A model with z up, as scenes load it. */
    static TriangleMesh worldMesh(String model) {
        return new ModelLoader(MODELS).load(ModelSettings.of(model + ".obj")).mesh();
    }

    /** A model with z up at a place, m. */
    static TriangleMesh worldMesh(String model, Position at) {
        return new ModelLoader(MODELS)
                .load(ModelSettings.of(model + ".obj").withPosition(at))
                .mesh();
    }

    /** The two houses of brick on asphalt of the tests of late specular reflections, z up. */
    static TriangleMesh canyon() {
        return new ModelLoader(SOUND).loadAsWritten("canyon.obj").mesh();
    }

    /**
     * The same triangles in an order that has nothing to do with their places, as some scanners and converters write
     * them.
     */
    static TriangleMesh shuffled(TriangleMesh mesh) {
        int[] order = IntStream.range(0, mesh.triangleCount()).toArray();
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = order.length - 1; i > 0; i--) {
            int other = random.nextInt(i + 1);
            int swap = order[i];
            order[i] = order[other];
            order[other] = swap;
        }
        float[] coordinates = new float[9 * order.length];
        for (int i = 0; i < coordinates.length; i++) {
            coordinates[i] = mesh.coordinate(order[i / 9], i / 3 % 3, i % 3);
        }
        return TriangleMesh.of(coordinates, IntStream.range(0, 3 * order.length).toArray());
    }

    /** The rays of a picture ("camera"), or those that bounce about what it shows ("diffuse"). */
    static RaySet rays(KDTree tree, String kind) {
        RayGenerator generator = new RayGenerator(tree, SEED);
        RaySet camera = generator.camera();
        return kind.equals("camera") ? camera : generator.diffuse(camera);
    }
}
