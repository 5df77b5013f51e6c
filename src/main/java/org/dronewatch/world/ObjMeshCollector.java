package org.dronewatch.world;

import de.javagl.obj.FloatTuple;
import de.javagl.obj.ObjFace;
import de.javagl.obj.WritableObj;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;

/** Takes what the OBJ parser finds, checks it while its line is still known, and makes a mesh of it. */
final class ObjMeshCollector implements WritableObj {
    /** The name of the material of faces that name none. */
    static final String NO_MATERIAL = "default";

    private static final int MAX_TRIANGLES = 50_000_000;

    private final String file;
    private final ObjLines lines;
    private final Placement placement;
    private final Floats vertices = new Floats();
    private final Ints corners = new Ints();
    private final Ints lineOfTriangle = new Ints();
    private final Ints materials = new Ints();
    private final Map<String, Integer> materialNumbers = new LinkedHashMap<>();
    private final List<String> libraries = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();
    private String material = NO_MATERIAL;
    private int dropped;

    ObjMeshCollector(String file, ObjLines lines, Placement placement) {
        this.file = file;
        this.lines = lines;
        this.placement = placement;
    }

    @Override
    public void addVertex(FloatTuple vertex) {
        if (vertex.getDimensions() < 3) {
            throw new InputException(lines.at(file) + "vertex has " + vertex.getDimensions() + " coordinates, needs 3");
        }
        addVertex(vertex.getX(), vertex.getY(), vertex.getZ());
    }

    @Override
    public void addVertex(float x, float y, float z) {
        placement.place(x, y, z, vertices);
        for (int i = vertices.size() - 3; i < vertices.size(); i++) {
            if (!(Math.abs(vertices.get(i)) <= TriangleMesh.MAX_COORDINATE)) {
                throw new InputException(lines.at(file) + "vertex (" + x + ", " + y + ", " + z
                        + ") must be finite and at most " + TriangleMesh.MAX_COORDINATE + " m from the origin");
            }
        }
    }

    @Override
    public void addFace(ObjFace face) {
        int size = face.getNumVertices();
        if (size < 3) {
            throw new InputException(lines.at(file) + "face has " + size + " corners, needs 3 or more");
        }
        for (int i = 0; i < size; i++) {
            if (face.getVertexIndex(i) < 0) {
                throw new InputException(lines.at(file) + "vertex index " + (face.getVertexIndex(i) - vertexCount())
                        + " points before the first of " + vertexCount() + " vertices");
            }
        }
        for (int i = 1; i + 1 < size; i++) {
            addTriangle(face.getVertexIndex(0), face.getVertexIndex(i), face.getVertexIndex(i + 1));
        }
    }

    private void addTriangle(int a, int b, int c) {
        if (materials.size() == MAX_TRIANGLES) {
            throw new InputException(lines.at(file) + "more than " + MAX_TRIANGLES + " triangles");
        }
        corners.add(a);
        corners.add(b);
        corners.add(c);
        lineOfTriangle.add(lines.line());
        materials.add(materialNumbers.computeIfAbsent(material, name -> materialNumbers.size()));
    }

    private int vertexCount() {
        return vertices.size() / 3;
    }

    @Override
    public void setActiveMaterialGroupName(String name) {
        material = name.isEmpty() ? NO_MATERIAL : name;
    }

    @Override
    public void setMtlFileNames(Collection<? extends String> names) {
        libraries.addAll(names);
    }

    /** Checks what can be known at the end only: a face may come before its vertices. */
    void finish() {
        for (int i = 0; i < corners.size(); i++) {
            if (corners.get(i) >= vertexCount()) {
                throw new InputException(file + ":" + lineOfTriangle.get(i / 3) + ": vertex index "
                        + (corners.get(i) + 1) + " is beyond the last of " + vertexCount() + " vertices");
            }
        }
        if (corners.size() == 0) {
            throw new InputException(file + ": has no faces (" + vertexCount() + " vertices): not a mesh");
        }
    }

    /** The mesh without the triangles that have no area. */
    TriangleMesh toMesh(String name) {
        Ints keptCorners = new Ints();
        Ints keptMaterials = new Ints();
        Ints sourceNumbers = new Ints();
        for (int i = 0; i < materials.size(); i++) {
            if (hasArea(i)) {
                for (int k = 0; k < 3; k++) {
                    keptCorners.add(corners.get(3 * i + k));
                }
                keptMaterials.add(materials.get(i));
                sourceNumbers.add(i);
            }
        }
        dropped = materials.size() - keptMaterials.size();
        if (keptMaterials.size() == 0) {
            throw new InputException(name + ": none of its " + materials.size() + " triangles has an area: not a mesh");
        }
        return new TriangleMesh(
                vertices.toArray(),
                keptCorners.toArray(),
                keptMaterials.toArray(),
                sourceNumbers.toArray(),
                materialNames());
    }

    private boolean hasArea(int triangle) {
        int a = 3 * corners.get(3 * triangle);
        int b = 3 * corners.get(3 * triangle + 1);
        int c = 3 * corners.get(3 * triangle + 2);
        double[] cross = new double[3];
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            double bk = (double) vertices.get(b + k) - vertices.get(a + k);
            double bn = (double) vertices.get(b + next) - vertices.get(a + next);
            double ck = (double) vertices.get(c + k) - vertices.get(a + k);
            double cn = (double) vertices.get(c + next) - vertices.get(a + next);
            cross[k] = bk * cn - bn * ck;
        }
        return cross[0] != 0.0 || cross[1] != 0.0 || cross[2] != 0.0;
    }

    int dropped() {
        return dropped;
    }

    List<String> materialNames() {
        return List.copyOf(materialNumbers.keySet());
    }

    List<String> libraries() {
        return libraries;
    }

    List<String> warnings() {
        return warnings;
    }

    // What follows is read and not needed: texture coordinates, normals, groups, and forms the reader does not call.

    @Override
    public void addTexCoord(FloatTuple texCoord) {}

    @Override
    public void addTexCoord(float x) {}

    @Override
    public void addTexCoord(float x, float y) {}

    @Override
    public void addTexCoord(float x, float y, float z) {}

    @Override
    public void addNormal(FloatTuple normal) {}

    @Override
    public void addNormal(float x, float y, float z) {}

    @Override
    public void setActiveGroupNames(Collection<? extends String> groupNames) {}

    @Override
    public void addFace(int... v) {}

    @Override
    public void addFaceWithTexCoords(int... v) {}

    @Override
    public void addFaceWithNormals(int... v) {}

    @Override
    public void addFaceWithAll(int... v) {}

    @Override
    public void addFace(int[] v, int[] vt, int[] vn) {}
}
