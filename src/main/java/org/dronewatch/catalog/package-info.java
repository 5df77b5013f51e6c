/** Real sensors by name: knows every kind of sensor, and the only place where they are all named. */
package org.dronewatch.catalog;
