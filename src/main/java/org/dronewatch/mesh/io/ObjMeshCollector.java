package org.dronewatch.mesh.io;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.HeapBudget;

/** Takes what an OBJ file states, checks it while its line is still known, and makes a mesh of it. */
final class ObjMeshCollector {
    /** The name of the material of faces that name none. */
    static final String NO_MATERIAL = "default";

    private static final int MAX_TRIANGLES = 50_000_000;

    /** Bytes of a corner and of a face, in lists that have just grown. */
    private static final int CORNER = 12;

    private static final int FACE = 24;

    private final String file;
    private final HeapBudget budget;
    private final ObjLines lines;
    private final Placement placement;
    private final Floats vertices = new Floats();
    private final Ints corners = new Ints();
    private final Ints ends = new Ints();
    private final Ints lineOfFace = new Ints();
    private final Ints materials = new Ints();
    private final Map<String, Integer> materialNumbers = new LinkedHashMap<>();
    private final Set<String> libraries = new LinkedHashSet<>();
    private final Map<String, Integer> skipped = new TreeMap<>();
    private String material = NO_MATERIAL;

    /** The number of that material; negative until a face has it. */
    private int materialNumber = -1;

    private long triangles;

    ObjMeshCollector(String file, ObjLines lines, Placement placement) {
        this.file = file;
        this.budget = new HeapBudget(file, ModelCollector.ADVICE);
        this.lines = lines;
        this.placement = placement;
    }

    void addVertex(double x, double y, double z) {
        budget.take(ModelCollector.VERTEX);
        try {
            placement.place(x, y, z, vertices);
        } catch (InputException e) {
            throw new InputException(lines.at(file) + "vertex: " + e.getMessage(), e);
        }
        for (int i = vertices.size() - 3; i < vertices.size(); i++) {
            if (!(Math.abs(vertices.get(i)) <= TriangleMesh.MAX_COORDINATE)) {
                throw new InputException(lines.at(file) + "vertex (" + x + ", " + y + ", " + z
                        + ") must be finite and at most " + TriangleMesh.MAX_COORDINATE + " m from the origin");
            }
        }
    }

    /** A polygon of vertex indices as in the file: from 1, negative ones from the last vertex backwards. */
    void addFace(Ints indices) {
        int size = indices.size();
        if (size < 3) {
            throw new InputException(
                    lines.at(file) + "face has " + Counted.of(size, "corner") + " but needs 3 or more");
        }
        triangles += size - 2;
        if (triangles > MAX_TRIANGLES) {
            throw new InputException(lines.at(file) + "more than " + MAX_TRIANGLES + " triangles");
        }
        budget.take(FACE + (long) CORNER * size + (long) ModelCollector.TRIANGLE * (size - 2));
        for (int i = 0; i < size; i++) {
            corners.add(vertex(indices.get(i)));
        }
        ends.add(corners.size());
        lineOfFace.add(lines.line());
        if (materialNumber < 0) {
            materialNumber = materialNumbers.computeIfAbsent(material, name -> materialNumbers.size());
        }
        materials.add(materialNumber);
    }

    private int vertex(int index) {
        if (index == 0) {
            throw new InputException(lines.at(file) + "vertex index 0, but the first vertex has index 1");
        }
        if (index < -vertexCount()) {
            throw new InputException(lines.at(file) + "vertex index " + index + " lies before the first vertex ("
                    + vertices() + " so far)");
        }
        return index < 0 ? vertexCount() + index : index - 1;
    }

    private int vertexCount() {
        return vertices.size() / 3;
    }

    private String vertices() {
        return Counted.of(vertexCount(), "vertex", "vertices");
    }

    void useMaterial(String name) {
        material = name.isEmpty() ? NO_MATERIAL : name;
        materialNumber = -1;
    }

    void addLibrary(String name) {
        libraries.add(name);
    }

    /** Counts a statement without effect. */
    void skip(String word) {
        skipped.merge(word, 1, Integer::sum);
    }

    /** Checks what can be known at the end only: a face may come before its vertices. */
    void finish() {
        int face = 0;
        for (int i = 0; i < corners.size(); i++) {
            if (i == ends.get(face)) {
                face++;
            }
            if (corners.get(i) >= vertexCount()) {
                throw new InputException(file + ":" + lineOfFace.get(face) + ": vertex index " + (corners.get(i) + 1)
                        + " lies beyond the last vertex (" + vertices() + ")");
            }
        }
        if (corners.size() == 0) {
            throw new InputException(file + ": has no faces (" + vertices() + "): not a mesh");
        }
    }

    /**
     * The mesh without the triangles that have no area.
     *
     * @param warnings takes a line when polygons cross themselves
     */
    TriangleMesh toMesh(List<String> warnings) {
        MeshTriangles mesh = new MeshTriangles(vertices);
        int uncut = 0;
        int firstUncut = 0;
        int start = 0;
        for (int face = 0; face < materials.size(); face++) {
            int end = ends.get(face);
            if (end - start == 3) {
                mesh.add(corners.get(start), corners.get(start + 1), corners.get(start + 2), materials.get(face));
            } else if (!mesh.add(corners.copyOfRange(start, end), materials.get(face)) && uncut++ == 0) {
                firstUncut = lineOfFace.get(face);
            }
            start = end;
        }
        if (uncut > 0) {
            warnings.add(file + ":" + firstUncut
                    + ": polygon crosses itself or has too many corners close together, and was cut into a fan of triangles"
                    + (uncut > 1 ? "; so were " + (uncut - 1) + " more" : ""));
        }
        if (mesh.size() == 0) {
            throw new InputException(file + ": has no area (" + Counted.of(triangles, "triangle") + "): not a mesh");
        }
        return mesh.toMesh(materialNames());
    }

    /** How many triangles the polygons have, those without area, too. */
    int triangles() {
        return (int) triangles;
    }

    List<String> materialNames() {
        return List.copyOf(materialNumbers.keySet());
    }

    /** The names of the material libraries, each once. */
    Collection<String> libraries() {
        return libraries;
    }

    /** How many statements of each word were skipped. */
    Map<String, Integer> skipped() {
        return skipped;
    }

    /** A line when skipped statements would have added surfaces. */
    List<String> warnings() {
        List<String> missing = new ArrayList<>();
        skipped.forEach((word, count) -> {
            if (ObjWords.isOfSurfaces(word)) {
                missing.add(count + " " + word);
            }
        });
        return missing.isEmpty()
                ? List.of()
                : List.of(file + ": statements that define surfaces were skipped, so these surfaces are missing: "
                        + String.join(", ", missing));
    }
}
