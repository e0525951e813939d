#include <gtest/gtest.h>
#include <cstdio>
#include "support/scene.hpp"
using namespace scene;
TEST(Explore, FreeFall){
 Scene s; int b=s.box({0,0},1,1); Simulation sim(s);
 auto o=sim.shake(1,0.001); printf("%s %d y %.12f v %.12f steps %zu res %g\n",o.message.c_str(),(int)o.status,sim.moved(b).y(),sim.velocity(b)[1],sim.reports.size(), sim.state.energy.residual());
}
TEST(Explore, Rest){
 Scene s; s.box({-1,-1},3,1,dda::Motion::fixed); int b=s.box({0,0},1,1); Simulation sim(s);
 auto o=sim.settle(); printf("%s pen %.6e steps %zu sy %g sx %g it %g\n",o.message.c_str(),sim.reports.back().largest_penetration,sim.reports.size(),sim.stress(b)[1],sim.stress(b)[0],sim.mean_iterations());
 sim.reports.clear(); o=sim.shake(10,0.005); printf("%s moved %g %g it %g res %g\n",o.message.c_str(),sim.moved(b).x(),sim.moved(b).y(),sim.mean_iterations(),sim.state.energy.residual());
}
TEST(Explore, Incline){
 for(double psi: {22.6,30.,45.}) for(double phi: {0.,5.,10.,20.,30.}) { if(phi>=psi) continue;
 Scene s; s.friction(phi); double a=radians(psi); s.box(Vec2(0,0)-Vec2(-std::sin(a),std::cos(a))*1,40,1,dda::Motion::fixed,a); int b=s.box(Vec2(std::cos(a),std::sin(a))*30,1,1,dda::Motion::free,a);
 s.friction(89); Simulation sim(s); auto o=sim.settle(); 
 Scene s2; s2.friction(phi);
 const_cast<dda::Model&>(sim.model).joint_materials[0].law=Scene::mohr_coulomb(phi);
 size_t n0=sim.reports.size();double it0=sim.mean_iterations(); sim.reports.clear(); auto o2=sim.shake(1,0.001); double ex=0.5*g*(std::sin(a)-std::cos(a)*std::tan(radians(phi)));
 printf("psi %g phi %g: %s %s settle %zu (%.2f it) s %.6f expect %.6f err %.3g%% it %.2f res %g fric %g num %g KE %g\n",psi,phi,o.message.c_str(),o2.message.c_str(),n0,it0,sim.moved(b).norm(),ex,100*(sim.moved(b).norm()/ex-1),sim.mean_iterations(),sim.state.energy.residual(),sim.state.energy.friction_loss,sim.state.energy.numerical_loss,sim.state.energy.kinetic);
 }
}
TEST(Explore, StandStill){
 for(double pen: {1e10,1e11,1e12}) for(double dt: {1e-4,1e-3,1e-2}) for(int settled: {1,0}) {
 Scene s; s.friction(35); s.model.normal_penalty=s.model.shear_penalty=pen; double a=radians(30); s.box(Vec2(0,0)-Vec2(-std::sin(a),std::cos(a))*1,40,1,dda::Motion::fixed,a); int b=s.box(Vec2(std::cos(a),std::sin(a))*30,1,1,dda::Motion::free,a);
 Simulation sim(s); if(settled) {auto o=sim.settle(dt); if(o.status!=dda::RunStatus::completed) printf("%s\n",o.message.c_str());} size_t n0=sim.reports.size(); double it0=sim.mean_iterations(); sim.reports.clear(); auto o2=sim.shake(dt<1e-3?1:10,dt);
 printf("pen %g dt %g settled %d: settle %zu steps %.2f it; %s moved %.3e %.3e it %.2f v %g res %g\n",pen,dt,settled,n0,it0,o2.message.c_str(),sim.moved(b).x(),sim.moved(b).y(),sim.mean_iterations(),sim.velocity(b).norm(),sim.state.energy.residual());
 }
}
