using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class TemplateTargetDetectorContractTests : TargetDetectorContract
{
    public TemplateTargetDetectorContractTests()
        : base(new TemplateTargetDetector(PanelTemplate.Classes))
    {
    }

    protected override byte[] Finish(byte[] painted) => PanelTemplate.ThroughRedFilter(painted);
}
