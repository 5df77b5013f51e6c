package org.dronewatch.models;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;

/** The surface of one part as a loose set of flat facets, before its corners are merged into shared vertices. */
final class Solid {

    /** One convex facet; the corners run counter-clockwise when seen from outside. */
    record Facet(Material material, List<Point> corners) {

        Facet reversed() {
            List<Point> backwards = new ArrayList<>(corners);
            Collections.reverse(backwards);
            return new Facet(material, backwards);
        }

        /** Six times the signed volume of the fan of tetrahedra from {@code apex} to this facet. */
        double sixfoldVolume(Point apex) {
            Point first = corners.get(0).minus(apex);
            double sum = 0;
            for (int i = 1; i + 1 < corners.size(); i++) {
                Point second = corners.get(i).minus(apex);
                sum += first.dot(second.cross(corners.get(i + 1).minus(apex)));
            }
            return sum;
        }
    }

    private final List<Facet> facets = new ArrayList<>();

    Solid add(Material material, Point... corners) {
        return add(material, List.of(corners));
    }

    Solid add(Material material, List<Point> corners) {
        facets.add(new Facet(material, List.copyOf(corners)));
        return this;
    }

    /** Closes an outline with triangles around its centre, which keeps them well shaped. */
    Solid addFan(Material material, List<Point> outline) {
        Point centre = centre(outline);
        for (int i = 0; i < outline.size(); i++) {
            add(material, centre, outline.get(i), outline.get((i + 1) % outline.size()));
        }
        return this;
    }

    /** Volume in cubic metres, positive when the facets face outward. */
    double signedVolume() {
        Point apex = facets.get(0).corners().get(0);
        return facets.stream().mapToDouble(f -> f.sixfoldVolume(apex)).sum() / 6;
    }

    /** This solid with a motion applied to every corner. */
    Solid moved(UnaryOperator<Point> motion) {
        Solid other = new Solid();
        for (Facet facet : facets) {
            other.add(facet.material(), facet.corners().stream().map(motion).toList());
        }
        return other;
    }

    /** All corners, once for each facet that has them. */
    List<Point> corners() {
        return facets.stream().flatMap(facet -> facet.corners().stream()).toList();
    }

    /** The facets, turned over as a whole if they happened to face inward. */
    List<Facet> outwardFacets() {
        if (signedVolume() >= 0) {
            return List.copyOf(facets);
        }
        return facets.stream().map(Facet::reversed).toList();
    }

    static Point centre(List<Point> points) {
        Point sum = new Point(0, 0, 0);
        for (Point p : points) {
            sum = sum.plus(p);
        }
        return sum.times(1.0 / points.size());
    }
}
