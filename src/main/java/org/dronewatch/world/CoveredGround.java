package org.dronewatch.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The materials of a mesh whose ground is covered by what a map shows: they are looked up at a point, since triangles
 * of the ground are larger than roads. Immutable, shared by all threads.
 */
final class CoveredGround {
    private static final int OF_THE_MESH = -1;

    private final TriangleMesh mesh;
    private final LandRaster raster;
    private final int groundTriangles;
    private final int[] materialOfClass;
    private final List<String> names;

    /**
     * Covers the ground of a mesh.
     *
     * @param groundTriangles how many triangles of the mesh, its first ones, are ground
     */
    CoveredGround(TriangleMesh mesh, LandRaster raster, int groundTriangles) {
        this.mesh = mesh;
        this.raster = raster;
        this.groundTriangles = groundTriangles;
        this.materialOfClass = new int[LandClass.all().size()];
        Arrays.fill(materialOfClass, OF_THE_MESH);
        double[] areas = raster.areas();
        List<String> all = new ArrayList<>(mesh.materialNames());
        for (LandClass land : LandClass.all()) {
            if (land != LandClass.NONE && areas[land.code()] > 0.0) {
                materialOfClass[land.code()] = all.size();
                all.add(land.material());
            }
        }
        this.names = List.copyOf(all);
    }

    /** The materials of the mesh, and after them those of the classes that occur. */
    List<String> names() {
        return names;
    }

    boolean isGround(int triangle) {
        return triangle < groundTriangles;
    }

    /** The number of the material of a triangle at a point on it. */
    int material(int triangle, double x, double y) {
        int covering = isGround(triangle) ? materialOfClass[raster.code(x, y)] : OF_THE_MESH;
        return covering == OF_THE_MESH ? mesh.material(triangle) : covering;
    }
}
