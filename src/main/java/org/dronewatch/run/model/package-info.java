/** What is read or built for a site and its drones before a run, and kept for the next. */
package org.dronewatch.run.model;
