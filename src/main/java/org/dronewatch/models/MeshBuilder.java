package org.dronewatch.models;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Collects parts into a {@link Mesh}. Coordinates are rounded to the decimals of the file, and corners of one part that
 * round to the same position become one vertex, so that a closed solid is also closed in the file.
 */
public final class MeshBuilder {

    private record Place(long x, long y, long z) {}

    private final String name;
    private final int decimals;
    private final double unitsPerMetre;
    private final List<Point> vertices = new ArrayList<>();
    private final List<Mesh.Part> parts = new ArrayList<>();

    /**
     * Starts an empty mesh.
     *
     * @param name model name
     * @param decimals digits after the decimal point, 0 to 9
     */
    public MeshBuilder(String name, int decimals) {
        this.name = name;
        this.decimals = decimals;
        this.unitsPerMetre = StrictMath.pow(10, decimals);
    }

    /** Adds a closed solid as a separate part, turning its faces outward if need be. */
    MeshBuilder add(String partName, Solid solid) {
        return addFacets(partName, solid.outwardFacets());
    }

    /** Adds an open surface whose facets are already oriented as they should face. */
    MeshBuilder addFacets(String partName, List<Solid.Facet> facets) {
        Map<Place, Integer> known = new HashMap<>();
        List<Mesh.Face> faces = new ArrayList<>();
        for (Solid.Facet facet : facets) {
            List<Integer> corners = corners(facet, known);
            if (corners.size() >= 3) {
                faces.add(new Mesh.Face(facet.material(), corners));
            }
        }
        parts.add(new Mesh.Part(partName, faces));
        return this;
    }

    /** Corner indices without repetitions: a facet that shrinks to a line by rounding disappears. */
    private List<Integer> corners(Solid.Facet facet, Map<Place, Integer> known) {
        List<Integer> corners = new ArrayList<>();
        for (Point p : facet.corners()) {
            Integer index = known.computeIfAbsent(place(p), this::newVertex);
            if (!corners.contains(index)) {
                corners.add(index);
            }
        }
        return corners;
    }

    private Place place(Point p) {
        return new Place(
                Math.round(p.x() * unitsPerMetre),
                Math.round(p.y() * unitsPerMetre),
                Math.round(p.z() * unitsPerMetre));
    }

    private int newVertex(Place place) {
        vertices.add(new Point(place.x() / unitsPerMetre, place.y() / unitsPerMetre, place.z() / unitsPerMetre));
        return vertices.size() - 1;
    }

    /** The mesh as collected so far. */
    public Mesh build() {
        return new Mesh(name, decimals, vertices, parts);
    }
}
