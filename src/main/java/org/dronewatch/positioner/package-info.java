/** Mounts that turn: they search, and once another sensor tells them where to look, they follow. */
package org.dronewatch.positioner;
