/** The buildings of a real place: outlines and heights of a map become solids in the world frame. */
package org.dronewatch.buildings;
