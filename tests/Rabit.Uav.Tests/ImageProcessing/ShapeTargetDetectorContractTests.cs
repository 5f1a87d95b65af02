using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class ShapeTargetDetectorContractTests : TargetDetectorContract
{
    public ShapeTargetDetectorContractTests()
        : base(new ShapeTargetDetector(TargetClass.Defaults))
    {
    }
}
