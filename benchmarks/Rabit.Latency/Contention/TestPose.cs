namespace Rabit.Latency.Contention;

/// <summary>A message of common size: 72 bytes, all nine the same, so that a torn one shows.</summary>
internal struct TestPose
{
    public double TimeSeconds { get; set; }
    public double NorthMetres { get; set; }
    public double EastMetres { get; set; }
    public double DownMetres { get; set; }
    public double RollRadians { get; set; }
    public double PitchRadians { get; set; }
    public double YawRadians { get; set; }
    public double GroundSpeed { get; set; }
    public double ClimbRate { get; set; }
}
