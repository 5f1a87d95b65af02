namespace Rabit.Vision.Speed;

/// <summary>What a pass over the pictures of a set took, a picture.</summary>
internal readonly record struct PassResult(double Milliseconds, double AllocatedBytes, int Found);
