package org.dronewatch.geometry;

import org.jogamp.vecmath.Vector3d;

/**
 * A triangle of a mesh as a value, for convenience: the ray tracers do not use this class.
 *
 * @param a first corner, m
 * @param b second corner, m
 * @param c third corner, m
 * @param id the triangle's number in its mesh
 * @param material the number of its material in the mesh's list of names
 */
public record Triangle(Position a, Position b, Position c, int id, int material) {

    /**
     * The cross product of the edges a-b and a-c: perpendicular to the triangle, on the side from which a, b, c run
     * counter-clockwise; its length is twice the area.
     */
    public Vector3d areaNormal() {
        Vector3d normal = new Vector3d();
        normal.cross(b.minus(a).toVector3d(), c.minus(a).toVector3d());
        return normal;
    }

    /** Area in m². */
    public double area() {
        return 0.5 * areaNormal().length();
    }

    /** The smallest box around the triangle. */
    public AABB bounds() {
        return new AABB(
                Math.min(a.x(), Math.min(b.x(), c.x())),
                Math.min(a.y(), Math.min(b.y(), c.y())),
                Math.min(a.z(), Math.min(b.z(), c.z())),
                Math.max(a.x(), Math.max(b.x(), c.x())),
                Math.max(a.y(), Math.max(b.y(), c.y())),
                Math.max(a.z(), Math.max(b.z(), c.z())));
    }
}
