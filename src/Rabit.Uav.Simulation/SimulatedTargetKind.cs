namespace Rabit.Uav.Simulation;

/// <summary>What the targets of a simulated world are like, and the names of their classes.</summary>
public enum SimulatedTargetKind
{
    /// <summary>A square of 1 m in one of five colours, in turn: red, orange, blue, yellow and magenta.</summary>
    ColouredPanel,

    /// <summary>A white square of 1 m, of the class "white".</summary>
    WhitePanel,

    /// <summary>A black square of 1 m, of the class "black".</summary>
    BlackPanel,

    /// <summary>
    /// A square of 1 m in two colours, in turn: red and white halves ("red-white"), blue and yellow halves
    /// ("blue-yellow"), and black and white quarters ("black-white").
    /// </summary>
    TwoColouredPanel,

    /// <summary>A person who lies on the ground, 1.75 m by 0.65 m, in a jacket of one colour ("person").</summary>
    Person,

    /// <summary>A car from above, 4.4 m by 1.8 m, with dark windows ("car").</summary>
    Car,

    /// <summary>
    /// A printed marker of <see cref="Vision.MarkerFamily.ArUco4x4"/>, 1.6 m without its white border ("aruco").
    /// </summary>
    ArUcoMarker,

    /// <summary>
    /// A printed marker of <see cref="Vision.MarkerFamily.AprilTag36h11"/>, 1.6 m without its border ("apriltag").
    /// </summary>
    AprilTagMarker,
}
