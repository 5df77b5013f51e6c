package org.dronewatch.mesh.io;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.HeapBudget;

/**
 * Collects the contents of a file for a {@link MeshReader}, and makes a model from them: places vertices, cuts polygons
 * into triangles, drops and counts triangles without area, and checks all limits. Not thread-safe.
 */
public final class ModelCollector {
    /** Maximum number of triangles of a model. */
    public static final int MAX_TRIANGLES = 50_000_000;

    /** Bytes of a vertex and of a triangle, in lists that have just grown and are copied. */
    static final int VERTEX = 44;

    static final int TRIANGLE = 72;

    /** What can be done about a model that takes too much memory. */
    static final String ADVICE = "simplify the model";

    private final ModelFile file;
    private final HeapBudget budget;
    private final Placement placement;
    private final Floats vertices = new Floats();
    private final MeshTriangles triangles = new MeshTriangles(vertices);
    private final Map<String, Integer> materials = new LinkedHashMap<>();
    private final Map<String, Integer> colours = new LinkedHashMap<>();
    private final List<String> warnings = new ArrayList<>();
    private long stated;
    private long faces;

    /**
     * A collector for one file.
     *
     * @throws InputException when the coordinates are those of a national grid, and the scene's origin is not known
     */
    public ModelCollector(ModelFile file, ModelSettings settings) {
        this.file = file;
        this.budget = new HeapBudget(file.name(), ADVICE);
        this.placement = file.placement(settings);
    }

    /**
     * Adds a vertex in the file's own coordinates, which are rounded to single precision only after the vertex has been
     * placed: coordinates of a national grid remain exact if the model has a {@linkplain ModelSettings#crs() crs}, or
     * if its {@linkplain ModelSettings#origin() origin} lies on the site.
     *
     * @return the index of the vertex, from 0 on
     * @throws InputException when the vertex is not finite, is placed too far from the origin, does not fit into
     *     memory, or lies outside the domain of the model's grid
     */
    public int addVertex(double x, double y, double z) {
        budget.take(VERTEX);
        try {
            placement.place(x, y, z, vertices);
        } catch (InputException e) {
            throw new InputException(file.name() + ": vertex " + vertices.size() / 3 + ": " + e.getMessage(), e);
        }
        for (int i = vertices.size() - 3; i < vertices.size(); i++) {
            if (!(Math.abs(vertices.get(i)) <= TriangleMesh.MAX_COORDINATE)) {
                throw new InputException(
                        file.name() + ": vertex " + (vertices.size() / 3 - 1) + " (" + x + ", " + y + ", " + z
                                + ") must be finite and at most " + TriangleMesh.MAX_COORDINATE + " m from the origin");
            }
        }
        return vertices.size() / 3 - 1;
    }

    /**
     * Adds a planar polygon.
     *
     * @param material name of the material; not empty
     * @param corners three or more indices of vertices that were added before
     * @throws InputException when there are fewer than three corners, a corner is not the index of a vertex, or there
     *     are too many triangles, in total or for the memory that Java may use
     */
    public void addFace(String material, int... corners) {
        if (corners.length < 3) {
            throw new InputException(file.name() + ": face " + faces + " has " + Counted.of(corners.length, "corner")
                    + " but needs 3 or more");
        }
        for (int corner : corners) {
            if (corner < 0 || corner >= vertices.size() / 3) {
                throw new InputException(file.name() + ": face " + faces + ": vertex index " + corner + " must be 0 to "
                        + (vertices.size() / 3 - 1));
            }
        }
        faces++;
        stated += corners.length - 2;
        if (stated > MAX_TRIANGLES) {
            throw new InputException(file.name() + ": more than " + MAX_TRIANGLES + " triangles");
        }
        int before = triangles.size();
        triangles.add(corners.clone(), materials.computeIfAbsent(material, name -> materials.size()));
        budget.take((long) TRIANGLE * (triangles.size() - before));
    }

    /** The memory that the content of the file may take. */
    HeapBudget budget() {
        return budget;
    }

    /**
     * Sets the colour of a material in daylight.
     *
     * @param colour red, green and blue in the lowest 24 bits
     */
    public void setColour(String material, int colour) {
        colours.put(material, colour & 0xFFFFFF);
    }

    /** Adds a line about suspicious content that is not an error. */
    public void warn(String line) {
        warnings.add(line);
    }

    /**
     * The model.
     *
     * @throws InputException when the model has no triangle with an area
     */
    public LoadedModel toModel() {
        if (triangles.size() == 0) {
            throw new InputException(
                    file.name() + ": has no area (" + Counted.of(stated, "triangle") + "): not a mesh");
        }
        TriangleMesh mesh = triangles.toMesh(List.copyOf(materials.keySet()));
        int dropped = (int) stated - mesh.triangleCount();
        return new LoadedModel(file.name(), mesh, dropped, Map.of(), colours, List.of(file.hash()), warnings);
    }
}
