using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Web.Tests.Api;

/// <summary>
/// The public surface of the package changes only on purpose. To change it: run <c>RABIT_UPDATE_API=1 dotnet test
/// tests/Rabit.Uav.Web.Tests</c>, and commit PublicApi.txt together with the change.
/// </summary>
public sealed class PublicApiTests
{
    [Fact]
    public void PublicSurface_OfTheAssembly_IsThatOfTheFile()
        => PublicApiText.AssertUnchanged(typeof(LivePage).Assembly, "tests/Rabit.Uav.Web.Tests/Api/PublicApi.txt");
}
